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
  # What is installed may be moved.
  file(RENAME ${scratch}/prefix ${scratch}/moved)
  set(options -DCMAKE_PREFIX_PATH=${scratch}/moved)
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

# A moved program finds the script that came with it: a python3 of ours says what it is asked to run.
if(VARIANT STREQUAL installed)
  file(WRITE ${scratch}/bin/python3 "#!/bin/sh\necho \"$1\" >${scratch}/script\n")
  file(CHMOD ${scratch}/bin/python3 PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  run(${CMAKE_COMMAND} -E env PATH=${scratch}/bin:$ENV{PATH} ${scratch}/moved/bin/geolloyd
      profile scan.ply --seeds 16 --output profiled)
  file(READ ${scratch}/script script)
  file(REAL_PATH ${scratch}/moved moved)
  if(NOT script STREQUAL "${moved}/share/geolloyd/plot.py\n")
    message(FATAL_ERROR "the moved program runs ${script}")
  endif()
endif()
