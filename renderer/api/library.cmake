# libasos: the objects of all libraries that the public interface needs, linked once more. Static, or shared
# with BUILD_SHARED_LIBS. asos_exports is the shared library for the test of its symbols.
set(objects)
foreach(library files geometry sampling film scene gltf settings world features rays lights shading kernels
    pyray shadows published reflections prepared samples asos comparison picture session stability study api)
  list(APPEND objects "$<TARGET_OBJECTS:asos_${library}>")
endforeach()

# The libraries of the system: packaging/asosConfig.cmake.in finds the same ones.
find_package(PkgConfig REQUIRED)
pkg_check_modules(WEBP REQUIRED IMPORTED_TARGET libwebp)
pkg_check_modules(HIGHWAY REQUIRED IMPORTED_TARGET libhwy)
foreach(package OpenEXR PNG JPEG ZLIB draco meshoptimizer TBB)
  find_package(${package} REQUIRED)
endforeach()
find_package(embree 3 REQUIRED)

function(asos_link_library target)
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR})
  target_compile_features(${target} INTERFACE cxx_std_20)
  target_include_directories(${target} INTERFACE "$<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/include>")
  target_link_libraries(${target} PRIVATE OpenEXR::OpenEXR PNG::PNG JPEG::JPEG ZLIB::ZLIB draco::draco
    meshoptimizer::meshoptimizer PkgConfig::WEBP PkgConfig::HIGHWAY embree TBB::tbb fmt::fmt Threads::Threads)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL SHARED_LIBRARY)
    set(script "${CMAKE_CURRENT_SOURCE_DIR}/exports.map")
    target_link_options(${target} PRIVATE "LINKER:--version-script=${script}"
      "$<$<NOT:$<BOOL:${ASOS_SANITIZE}>>:LINKER:-z,defs>")
    set_target_properties(${target} PROPERTIES LINK_DEPENDS "${script}")
    if(ASOS_SANITIZE)
      target_link_options(${target} PRIVATE -fsanitize=${ASOS_SANITIZE})
    endif()
  endif()
endfunction()

add_library(libasos ${objects})
set_target_properties(libasos PROPERTIES OUTPUT_NAME asos EXPORT_NAME asos)
asos_link_library(libasos)
if(NOT BUILD_SHARED_LIBS AND NOT ASOS_SANITIZE)
  add_library(asos_exports SHARED ${objects})
  asos_link_library(asos_exports)
endif()
