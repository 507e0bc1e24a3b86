# What build_facts.cpp says. The commit changes without a file of ours doing so: configuring depends
# on git's log of it. A "+" says that files were not as committed when this was configured.
set(commit "")
find_package(Git QUIET)
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --abbrev=7 --exclude=* --dirty=+
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${GIT_EXECUTABLE} rev-parse --git-path logs/HEAD
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE commit_log OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  get_filename_component(commit_log "${commit_log}" ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR})
  if(commit AND EXISTS ${commit_log})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${commit_log})
  endif()
endif()

find_package(Eigen3 REQUIRED)
find_package(OpenMP REQUIRED)
find_package(TBB REQUIRED)
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} ${GEOLLOYD_ARITHMETIC}" flags)
string(CONCAT libraries
  "oneTBB ${TBB_VERSION}, OpenMP ${OpenMP_CXX_VERSION}, Eigen ${Eigen3_VERSION}, "
  "Embree ${embree_VERSION}, Cairo ${cairo_VERSION}, fmt ${fmt_VERSION}, CLI11 ${CLI11_VERSION}, "
  "nlohmann-json ${nlohmann_json_VERSION}")
set_source_files_properties(system/build_facts.cpp PROPERTIES COMPILE_DEFINITIONS
  "GEOLLOYD_VERSION=\"${PROJECT_VERSION}\";GEOLLOYD_COMMIT=\"${commit}\";GEOLLOYD_BUILD_TYPE=\"${CMAKE_BUILD_TYPE}\";GEOLLOYD_BUILD_FLAGS=\"${flags}\";GEOLLOYD_LIBRARIES=\"${libraries}\"")
