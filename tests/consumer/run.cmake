# Builds somebody else's project and runs what it makes: the README's example, and a host with the
# library in a shared object. VARIANT: installed (find_package) or added (add_subdirectory).
set(scratch ${BINARY_DIR}/consumer/${VARIANT})
file(REMOVE_RECURSE ${scratch})
file(MAKE_DIRECTORY ${scratch}/build)

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${scratch}/build COMMAND_ERROR_IS_FATAL ANY)
endfunction()

if(VARIANT STREQUAL installed)
  run(${CMAKE_COMMAND} --install ${BINARY_DIR} --prefix ${scratch}/prefix)
  file(GLOB_RECURSE headers RELATIVE ${scratch}/prefix/include ${scratch}/prefix/include/*)
  foreach(header ${headers})
    if(NOT header MATCHES "^geolloyd/[a-z_]+\\.h$")
      message(FATAL_ERROR "${header} is no public header, but is installed")
    endif()
  endforeach()
  set(options -DCMAKE_PREFIX_PATH=${scratch}/prefix)
else()
  set(options -DGEOLLOYD_SOURCE_DIR=${SOURCE_DIR} -DCMAKE_BUILD_TYPE=None -DCMAKE_UNITY_BUILD=ON
      -DGEOLLOYD_BUILD_TOOLS=OFF)
endif()
run(${CMAKE_COMMAND} -S ${SOURCE_DIR}/tests/consumer -B ${scratch}/build -G Ninja ${options}
    -DCMAKE_CXX_FLAGS=${CXX_FLAGS} -DCMAKE_CXX_COMPILER=${CXX_COMPILER})
run(${CMAKE_COMMAND} --build ${scratch}/build --target example host)
run(${PROGRAM} generate creature --triangles 20000 --output scan.ply)
run(${scratch}/build/example)
run(${scratch}/build/host)
