#include "tools/view/assets.h"

#include "geolloyd/errors.h"

#ifdef GEOLLOYD_VIEWER_FOLDER

// The bytes of a file of that folder, between two symbols. Compilers take minutes for as large an
// array.
#define GEOLLOYD_EMBED(name, file)                                            \
  asm(".pushsection .rodata\n"                                                \
      "geolloyd_" #name "_begin:\n.incbin \"" GEOLLOYD_VIEWER_FOLDER "/" file \
      "\"\ngeolloyd_" #name "_end:\n.popsection\n");                          \
  extern "C" const char geolloyd_##name##_begin[];                            \
  extern "C" const char geolloyd_##name##_end[];

GEOLLOYD_EMBED(script, "app.js")
GEOLLOYD_EMBED(style, "app.css")
GEOLLOYD_EMBED(index, "index.html")
GEOLLOYD_EMBED(page, "page.html")

namespace geolloyd {

ViewerAssets viewer_assets() {
  return {{geolloyd_script_begin, geolloyd_script_end},
          {geolloyd_style_begin, geolloyd_style_end},
          {geolloyd_index_begin, geolloyd_index_end},
          {geolloyd_page_begin, geolloyd_page_end}};
}

}  // namespace geolloyd

#else

namespace geolloyd {

ViewerAssets viewer_assets() {
  throw InvalidInput(
      "this geolloyd was built without its viewer: run tools/install-dependencies --viewer, then "
      "configure with -DGEOLLOYD_BUILD_VIEWER=ON and build it again");
}

}  // namespace geolloyd

#endif
