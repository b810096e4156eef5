# Image buffers, masks, comparison, PNG; and, apart from them, what needs OpenImageIO.
foreach(source buffer mask window compare ssim flip flip_hdr bad_input difference png temporary_file)
  list(APPEND image_sources ${CMAKE_CURRENT_LIST_DIR}/image_${source}_test.cpp)
endforeach()
find_package(PNG REQUIRED)
ggrade_test(image_test unit SOURCES ${image_sources} LIBRARIES ggrade_png PNG::PNG)
ggrade_test(image_files_test unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/image_files_test.cpp
  LIBRARIES ggrade_files ggrade_png PkgConfig::OpenImageIO)
