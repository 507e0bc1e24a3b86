# The browser's part of the viewer: bundled by esbuild, and put into the program. Where npm is not there, or cannot get
# the packages of package-lock.json, all else is built, and pages and `geolloyd view` say what is missing.
option(GEOLLOYD_BUILD_VIEWER "Build the browser's part of the viewer, if npm is there" ON)

set(viewer_app ${CMAKE_CURRENT_LIST_DIR}/app)
set(viewer_output ${CMAKE_CURRENT_BINARY_DIR}/viewer)
set(viewer_files app.js app.css index.html page.html)
list(TRANSFORM viewer_files PREPEND ${viewer_output}/)
set(viewer_modules ${viewer_app}/node_modules)

# Installs the packages where package-lock.json is newer than they are. Sets `viewer_lack` where it cannot.
function(install_viewer_packages)
  find_program(npm NAMES npm NO_CACHE)
  find_program(node NAMES node NO_CACHE)
  if(NOT npm OR NOT node)
    set(viewer_lack "npm is not there (tools/install-dependencies --viewer)" PARENT_SCOPE)
    return()
  endif()
  set(viewer_node ${node} PARENT_SCOPE)
  file(LOCK ${viewer_app} DIRECTORY GUARD FUNCTION TIMEOUT 120 RESULT_VARIABLE lock)
  set(installed ${viewer_modules}/.package-lock.json)
  if(EXISTS ${installed} AND NOT ${viewer_app}/package-lock.json IS_NEWER_THAN ${installed})
    return()
  endif()
  # npm ci itself waits for each package in turn before it gives up. A registry that answers, with an error too, is there.
  execute_process(
    COMMAND ${npm} ping --fetch-retries=0 --fetch-timeout=5000
    WORKING_DIRECTORY ${viewer_app} TIMEOUT 20 RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE said)
  if(failed AND NOT said MATCHES "code E[0-9]")
    set(viewer_lack "npm reaches no packages (npm ping in tools/view/app says why)" PARENT_SCOPE)
    return()
  endif()
  message(STATUS "Viewer: installing packages by npm")
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD=1
      ${npm} ci --ignore-scripts --no-audit --no-fund --fetch-retries=0
    WORKING_DIRECTORY ${viewer_app} TIMEOUT 300 RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(failed)
    set(viewer_lack "npm could not install its packages (npm ci in tools/view/app says why)" PARENT_SCOPE)
  endif()
endfunction()

set(viewer_lack "")
if(GEOLLOYD_BUILD_VIEWER)
  install_viewer_packages()
else()
  set(viewer_lack "GEOLLOYD_BUILD_VIEWER is OFF")
endif()

target_sources(geolloyd_tools PRIVATE view/assets.cpp)
set_source_files_properties(view/assets.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
if(viewer_lack)
  message(STATUS "Viewer: left out, for ${viewer_lack}")
else()
  file(GLOB viewer_sources CONFIGURE_DEPENDS ${viewer_app}/source/*)
  add_custom_command(OUTPUT ${viewer_files}
    COMMAND ${viewer_node} ${viewer_app}/build.mjs ${viewer_output}
    DEPENDS ${viewer_sources} ${viewer_app}/build.mjs ${viewer_modules}/.package-lock.json
    COMMENT "Bundling the viewer" VERBATIM)
  set_source_files_properties(view/assets.cpp PROPERTIES
    COMPILE_DEFINITIONS GEOLLOYD_VIEWER_FOLDER="${viewer_output}"
    OBJECT_DEPENDS "${viewer_files}")
endif()
