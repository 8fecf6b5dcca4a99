# Settings of every target of the project; none of them reaches those who link abut.
add_library(abut_settings INTERFACE)
target_compile_features(abut_settings INTERFACE cxx_std_20)
# No fused multiply-add: the same bits from every compiler and processor (docs/contract.md).
target_compile_options(abut_settings INTERFACE
  -ffp-contract=off -fno-math-errno -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  $<$<BOOL:${ABUT_WARNINGS_AS_ERRORS}>:-Werror>
  ${ABUT_HARDENING_COMPILE})
target_link_options(abut_settings INTERFACE ${ABUT_HARDENING_LINK})

# Sanitizers must see the whole program, test frameworks' inline code included.
if(ABUT_SANITIZE)
  add_compile_options(-fsanitize=${ABUT_SANITIZE} -fno-sanitize-recover=all
    -fno-omit-frame-pointer -g1)
  if(ABUT_SANITIZE_WITHOUT)
    add_compile_options(-fno-sanitize=${ABUT_SANITIZE_WITHOUT})
  endif()
  add_link_options(-fsanitize=${ABUT_SANITIZE})
  # Preconditions of the standard library are checked in the core as well.
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()
