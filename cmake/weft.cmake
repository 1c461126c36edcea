# weft_room(NAME [SOURCES ...] [PUBLIC ...] [PRIVATE ...]): one library a room, warnings on. Includes are written
# from the root of the repository. Without sources the room is headers only.
option(WEFT_WERROR "Warnings are errors" OFF)
set(WEFT_SANITIZE "" CACHE STRING "Sanitizers, e.g. address,undefined")

add_library(weft_flags INTERFACE)
target_compile_features(weft_flags INTERFACE cxx_std_20)
target_compile_options(weft_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wconversion -Wshadow>)
# GCC 12 raises these wrongly in optimised builds (its bugs 105329, 105651, 105562): strings and optionals.
target_compile_options(weft_flags INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-restrict -Wno-array-bounds -Wno-stringop-overread>)
if(WEFT_WERROR)
  target_compile_options(weft_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif()
if(WEFT_SANITIZE)
  # Optimised a little, with line numbers alone, and up to ten files read as one (the presets): enough for a report,
  # and a quarter of the time to build. Names that shadow one another only then are the release build's business.
  target_compile_options(weft_flags INTERFACE -Wno-shadow)
  # Of what UBSan checks, null, alignment, object-size, pointer-overflow and vptr take half of the time to compile: each
  # access to a member is one more. ASan stops at most of what they would find.
  set(unchecked -fno-sanitize=null,alignment,object-size,pointer-overflow,vptr)
  add_compile_options(-O1 -g1 -fsanitize=${WEFT_SANITIZE} ${unchecked} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${WEFT_SANITIZE} ${unchecked})
  if(WEFT_SANITIZE MATCHES address)
    # Eigen pads what it allocates when it sees ASan, and PCL, which is compiled without, frees such vectors as they are.
    # ASan's malloc aligns to 16 bytes, as glibc's does.
    add_compile_definitions(EIGEN_MALLOC_ALREADY_ALIGNED=1)
  endif()
endif()
find_program(WEFT_MOLD mold)
if(WEFT_MOLD AND NOT WEFT_SANITIZE STREQUAL "thread")
  add_link_options(-fuse-ld=mold)
endif()

function(weft_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  if(ROOM_SOURCES)
    add_library(${name} STATIC ${ROOM_SOURCES})
    target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name} PUBLIC ${ROOM_PUBLIC} PRIVATE weft_flags ${ROOM_PRIVATE})
    target_compile_features(${name} PUBLIC cxx_std_20)
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name} INTERFACE ${ROOM_PUBLIC})
  endif()
endfunction()

# weft_program(NAME SOURCES ... LINK ...): an executable in build/<preset>/bin.
function(weft_program name)
  cmake_parse_arguments(PROGRAM "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${PROGRAM_SOURCES})
  target_link_libraries(${name} PRIVATE weft_flags ${PROGRAM_LINK})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
endfunction()

# weft_test(NAME [THREADS] [LABEL unit|contract|data|drives|system] SOURCES ... LINK ...): one GoogleTest program, each of its
# tests in ctest. THREADS: what it tests is used by several; its label ends in -threads. Target unit_tests builds the
# unit tests, threads_tests those with threads. drives: renders whole drives; too long for a sanitizer. Under a
# sanitizer a program runs as a whole, in two shards for two cores: starting it takes longer there than most tests do.
# WHOLE: in every build, as what its tests share takes long to make. WEFT_SLOW_START: all unit tests.
# Their own files are optimised a little, what they test like the product: half of what a build compiles are tests.
set(WEFT_TEST_OPTIMISATION -O1 CACHE STRING "How a release optimises the tests' own files")
option(WEFT_SLOW_START "To start a program takes seconds on this machine, as its memory is slow" OFF)
add_custom_target(unit_tests)
add_custom_target(threads_tests)
function(weft_test name)
  cmake_parse_arguments(TEST "THREADS;WHOLE" "LABEL" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE weft_flags ${TEST_LINK} GTest::gtest GTest::gmock GTest::gtest_main)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:${WEFT_TEST_OPTIMISATION}>)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  if(NOT TEST_LABEL)
    set(TEST_LABEL unit)
  endif()
  if(TEST_LABEL STREQUAL unit)
    add_dependencies(unit_tests ${name})
  endif()
  if(TEST_THREADS)
    add_dependencies(threads_tests ${name})
    string(APPEND TEST_LABEL -threads)  # matches both -L unit and -L threads
  endif()
  if(NOT WEFT_SANITIZE AND NOT TEST_WHOLE AND NOT (WEFT_SLOW_START AND TEST_LABEL MATCHES unit))
    gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120 PROPERTIES LABELS "${TEST_LABEL}" TIMEOUT 1200)
    return()
  endif()
  foreach(shard 0 1)
    add_test(NAME ${name}.${shard} COMMAND ${name})
    set_tests_properties(${name}.${shard} PROPERTIES LABELS "${TEST_LABEL}" TIMEOUT 1800
      ENVIRONMENT "GTEST_TOTAL_SHARDS=2;GTEST_SHARD_INDEX=${shard}")
  endforeach()
endfunction()
