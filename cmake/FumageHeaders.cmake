# The headers that users of the library see. In this tree they are "core/effect/effect.h", a name that would collide in somebody else's
# include path: they are written to the build tree as "fumage/effect/effect.h", and installed and given to subprojects from there.
#   fumage_public_headers(<target> PUBLIC <headers that are promised>... ALL <headers that those may include>...)
# What the promised ones include comes with them, and is no promise.

function(fumage_public_headers target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "PUBLIC;ALL")
    set(stamp ${CMAKE_CURRENT_BINARY_DIR}/public_headers.stamp)
    set(script ${PROJECT_SOURCE_DIR}/cmake/public_headers.cmake)
    add_custom_command(OUTPUT ${stamp}
        COMMAND ${CMAKE_COMMAND} -DOUTPUT=${PROJECT_BINARY_DIR}/include/fumage -DROOT=${CMAKE_CURRENT_SOURCE_DIR} "-DPUBLIC=${arg_PUBLIC}"
            -DVERSION_HEADER=${PROJECT_BINARY_DIR}/generated/core/version.h -P ${script}
        COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
        DEPENDS ${arg_ALL} ${PROJECT_BINARY_DIR}/generated/core/version.h ${script}
        COMMENT "Writing the public headers" VERBATIM)
    add_custom_target(${target}_headers ALL DEPENDS ${stamp})
    add_dependencies(${target} ${target}_headers)
endfunction()
