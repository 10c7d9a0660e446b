# SPDX-License-Identifier: BSD-3-Clause
# Eigen and the standard library are half of what a file costs to compile. Each set is precompiled once
# and shared; all of it is compiled with the same flags, as GCC demands of whoever shares.
# A test runs once: it is hardly optimised, and compiles twice as fast.
# JSON is in a set of its own, because its literals make every file that includes it compile its parser.
function(galilean_header_set name)
  cmake_parse_arguments(arg "" "" "HEADERS;LINK" ${ARGN})
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/${name}.cpp CONTENT "")
  add_library(${name} STATIC ${PROJECT_BINARY_DIR}/generated/${name}.cpp)
  target_link_libraries(${name} PRIVATE Eigen3::Eigen ${arg_LINK} galilean_warnings)
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

add_library(galilean_runs_once INTERFACE)
target_compile_options(galilean_runs_once INTERFACE $<$<CONFIG:Release>:-O1> $<$<CONFIG:RelWithDebInfo>:-O0>)

function(galilean_precompile target set)
  if(GALILEAN_PCH AND TARGET ${set})
    target_precompile_headers(${target} REUSE_FROM ${set})
  endif()
endfunction()

# galilean_precompile_for(TARGET USES_JSON): with the set that fits it.
function(galilean_precompile_for target uses_json)
  if(uses_json AND TARGET galilean_json_headers)
    galilean_precompile(${target} galilean_json_headers)
  else()
    galilean_precompile(${target} galilean_headers)
  endif()
endfunction()

# galilean_compile_cold(TARGET USES_JSON): hardly optimised, where that is quicker to compile.
function(galilean_compile_cold target uses_json)
  if(CMAKE_BUILD_TYPE STREQUAL Release)
    galilean_precompile_for(${target} "${uses_json}")
  else()
    target_link_libraries(${target} PRIVATE galilean_runs_once)
    galilean_precompile(${target} galilean_cold_headers)
  endif()
endfunction()

if(GALILEAN_PCH)
  set(common <Eigen/Core> <algorithm> <array> <chrono> <deque> <filesystem> <fstream> <functional> <iostream>
             <map> <memory> <mutex> <optional> <set> <span> <sstream> <string> <string_view> <thread>
             <unordered_map> <variant> <vector>)
  if(CMAKE_BUILD_TYPE STREQUAL Release)
    galilean_header_set(galilean_headers HEADERS ${common})
    list(APPEND common <nlohmann/json.hpp>)
    galilean_header_set(galilean_json_headers HEADERS ${common})
  else()
    list(APPEND common <nlohmann/json.hpp>)
    galilean_header_set(galilean_headers HEADERS ${common})
    galilean_header_set(galilean_cold_headers HEADERS ${common} LINK galilean_runs_once)
  endif()
  galilean_header_set(galilean_web_headers LINK galilean_boost HEADERS ${common}
    <boost/asio/io_context.hpp> <boost/asio/ip/tcp.hpp> <boost/asio/post.hpp>
    <boost/asio/steady_timer.hpp> <boost/asio/write.hpp> <boost/beast/core/flat_buffer.hpp>
    <boost/beast/http.hpp> <boost/beast/websocket/stream.hpp>)
  if(GALILEAN_TESTS)
    galilean_header_set(galilean_test_headers HEADERS ${common} <gmock/gmock.h> <gtest/gtest.h>
                        LINK GTest::gtest GTest::gmock galilean_runs_once)
  endif()
endif()
