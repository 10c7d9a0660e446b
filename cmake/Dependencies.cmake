# SPDX-License-Identifier: BSD-3-Clause
# Every library from outside, found once, with a name that the folders link.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json REQUIRED)
find_package(CycloneDDS REQUIRED)
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(box2d REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto SSL)
find_package(Boost 1.81 REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(mrpt-maps REQUIRED)
find_package(mrpt-opengl REQUIRED)
find_package(mrpt-tfest REQUIRED)
find_package(mrpt-poses REQUIRED)

# Without a config file of their own.
foreach(library zstd lz4 deflate)
  find_library(${library}_LIBRARY ${library} REQUIRED)
  add_library(system::${library} INTERFACE IMPORTED)
  target_link_libraries(system::${library} INTERFACE ${${library}_LIBRARY})
endforeach()

# OpenCV's config file comes with libopencv-dev alone, which pulls Qt in: find the four libraries by name.
find_path(OPENCV_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
foreach(module core imgproc imgcodecs videoio)
  find_library(OPENCV_${module}_LIBRARY opencv_${module} REQUIRED)
  add_library(opencv::${module} INTERFACE IMPORTED)
  target_include_directories(opencv::${module} SYSTEM INTERFACE ${OPENCV_INCLUDE_DIR})
  target_link_libraries(opencv::${module} INTERFACE ${OPENCV_${module}_LIBRARY})
endforeach()

if(GALILEAN_TESTS)
  find_package(GTest REQUIRED)
  find_package(benchmark REQUIRED)
endif()

# What of Asio and Beast is no template is compiled once here, and not in every file that includes them:
# such a file takes two thirds of the time.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/boost_sources.cpp
     CONTENT "#include <boost/asio/impl/src.hpp>\n#include <boost/beast/src.hpp>\n")
add_library(galilean_boost STATIC EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/generated/boost_sources.cpp)
target_compile_definitions(galilean_boost PUBLIC
  BOOST_ASIO_SEPARATE_COMPILATION BOOST_BEAST_SEPARATE_COMPILATION)
# ThreadSanitizer does not know fences, which g++ refuses therefore. Asio's queues have a mutex as well.
if(GALILEAN_SANITIZE STREQUAL thread)
  target_compile_definitions(galilean_boost PUBLIC BOOST_ASIO_DISABLE_FENCED_BLOCK)
endif()
target_link_libraries(galilean_boost PUBLIC Boost::headers Threads::Threads)
set_target_properties(galilean_boost PROPERTIES UNITY_BUILD OFF)
# Apart, so that programs without TLS do not load OpenSSL's.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/boost_tls_sources.cpp
     CONTENT "#include <boost/asio/ssl/impl/src.hpp>\n")
add_library(galilean_boost_tls STATIC EXCLUDE_FROM_ALL
  ${PROJECT_BINARY_DIR}/generated/boost_tls_sources.cpp)
target_link_libraries(galilean_boost_tls PUBLIC galilean_boost OpenSSL::SSL)
set_target_properties(galilean_boost_tls PROPERTIES UNITY_BUILD OFF)
