# The three ways in which a folder adds to the build. Sources are always listed, never globbed.

# What demo.sh builds, and what the sanitizer builds build.
add_custom_target(programs ALL)
add_custom_target(unit_tests)

# galilean_library(NAME SOURCES a.cpp … LINK lib …): a static library, includable from the root.
function(galilean_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
  target_link_libraries(${name} PUBLIC ${arg_LINK} PRIVATE ${arg_PRIVATE_LINK} galilean_warnings)
  galilean_precompile(${name} galilean_headers)
endfunction()

# galilean_executable(NAME SOURCES main.cpp … LINK lib …): a program in build/bin.
function(galilean_executable name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} galilean_warnings)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  add_dependencies(programs ${name})
  galilean_precompile(${name} galilean_headers)
endfunction()

# galilean_test(NAME [THREADS] [DDS] SOURCES a_test.cpp … LINK lib …): a GoogleTest program, run by ctest.
# One program a folder keeps linking cheap; ctest still lists every test by its own name.
# THREADS marks tests that run under ThreadSanitizer as well; DDS those that must not run beside one
# another, since they would hear one another.
function(galilean_test name)
  cmake_parse_arguments(arg "THREADS;DDS" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} GTest::gtest GTest::gmock GTest::gtest_main galilean_warnings)
  target_compile_definitions(${name} PRIVATE GALILEAN_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                             GALILEAN_BINARY_DIR="${PROJECT_BINARY_DIR}")
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  add_dependencies(unit_tests ${name})
  galilean_precompile(${name} galilean_test_headers)
  set(label unit)
  if(arg_THREADS)
    set(label unit-threads)
  endif()
  set(properties TIMEOUT 300 LABELS ${label})
  if(arg_DDS)
    list(APPEND properties RESOURCE_LOCK dds)
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
endfunction()
