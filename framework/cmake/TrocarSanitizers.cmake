# Sanitizers apply to everything that is built, or their shadow state has holes.
if(TROCAR_SANITIZE)
  add_compile_options(-fsanitize=${TROCAR_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${TROCAR_SANITIZE})
endif()
