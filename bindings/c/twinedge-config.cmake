# find_package(twinedge): the targets twinedge::twinedge (shared) and twinedge::static.
get_filename_component(twinedge_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

if(NOT TARGET twinedge::twinedge)
  add_library(twinedge::twinedge SHARED IMPORTED)
  set_target_properties(twinedge::twinedge PROPERTIES
    IMPORTED_LOCATION "${twinedge_prefix}/lib/libtwinedge.so"
    IMPORTED_SONAME "libtwinedge.so.0"
    INTERFACE_INCLUDE_DIRECTORIES "${twinedge_prefix}/include")

  add_library(twinedge::static STATIC IMPORTED)
  set_target_properties(twinedge::static PROPERTIES
    IMPORTED_LOCATION "${twinedge_prefix}/lib/libtwinedge.a"
    INTERFACE_INCLUDE_DIRECTORIES "${twinedge_prefix}/include"
    INTERFACE_LINK_LIBRARIES "gcc_s;util;rt;pthread;m;dl;c")
endif()

unset(twinedge_prefix)
