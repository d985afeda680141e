# Layers, enforced. Every layer is a static library whose headers are visible under their path in the
# repository ("core/map/map.h"), but only to the targets that link it: each layer has an include root of its
# own, with one link in it to the layer's folder. A forbidden include does not compile.
function(celt_layer name folder)
  cmake_parse_arguments(layer "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  set(root ${PROJECT_BINARY_DIR}/include/${name})
  get_filename_component(parent ${root}/${folder} DIRECTORY)
  file(MAKE_DIRECTORY ${parent})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${root}/${folder} SYMBOLIC)
  if(layer_SOURCES)
    add_library(${name} STATIC ${layer_SOURCES})
    target_include_directories(${name} PUBLIC ${root})
    target_link_libraries(${name} PUBLIC ${layer_LINKS} PRIVATE celt_warnings ${layer_PRIVATE_LINKS})
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${root})
    target_link_libraries(${name} INTERFACE ${layer_LINKS})
  endif()
endfunction()
