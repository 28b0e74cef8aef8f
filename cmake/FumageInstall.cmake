# What is installed beside the programs.
#
# Manual pages and completions of the programs: made by running them, so that they never go stale. Not where a program cannot run here
# (cross-building without an emulator) or help2man is missing.
set(FUMAGE_MAINTAINER "The Fumage developers <fumage@users.noreply.github.com>" CACHE STRING "Who answers for packages that are made, as name <address>")
option(FUMAGE_BUILD_MANUAL "Make manual pages (needs help2man) and completions" ${PROJECT_IS_TOP_LEVEL})
set(FUMAGE_ZSH_FOLDER ${CMAKE_INSTALL_DATADIR}/zsh/site-functions CACHE STRING "Where zsh's completions are installed")
find_program(HELP2MAN help2man)

if(FUMAGE_BUILD_MANUAL AND CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    message(NOTICE "The programs do not run here: no manual pages and no completions.")
    set(FUMAGE_BUILD_MANUAL OFF)
elseif(FUMAGE_BUILD_MANUAL AND NOT HELP2MAN)
    message(NOTICE "Without help2man there will be no manual pages.")
endif()

# fumage_manual(<target> <component> <what it is>)
function(fumage_manual target component what)
    if(NOT FUMAGE_BUILD_MANUAL OR NOT HELP2MAN)
        return()
    endif()
    set(script ${PROJECT_SOURCE_DIR}/resources/manual/make_manual.sh)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/manual)
    add_custom_command(OUTPUT ${folder}.stamp
        COMMAND ${CMAKE_COMMAND} -E rm -rf ${folder}
        COMMAND bash ${script} $<TARGET_FILE:${target}> ${what} ${folder}
        COMMAND ${CMAKE_COMMAND} -E touch ${folder}.stamp
        DEPENDS ${target} ${script} ${PROJECT_SOURCE_DIR}/resources/manual/${target}.h2m COMMENT "Writing the manual of ${target}" VERBATIM)
    add_custom_target(${target}-manual ALL DEPENDS ${folder}.stamp)
    install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
endfunction()

# fumage_completions(<target> <component>): of a program that prints them.
function(fumage_completions target component)
    if(NOT FUMAGE_BUILD_MANUAL)
        return()
    endif()
    set(bash ${CMAKE_CURRENT_BINARY_DIR}/completions/${target})
    set(zsh ${CMAKE_CURRENT_BINARY_DIR}/completions/_${target})
    add_custom_command(OUTPUT ${bash} ${zsh}
        COMMAND ${target} completions bash > ${bash}
        COMMAND ${target} completions zsh > ${zsh}
        DEPENDS ${target} COMMENT "Writing the completions of ${target}" VERBATIM)
    file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/completions)
    add_custom_target(${target}-completions ALL DEPENDS ${bash} ${zsh})
    install(FILES ${bash} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT ${component})
    install(FILES ${zsh} DESTINATION ${FUMAGE_ZSH_FOLDER} COMPONENT ${component})
endfunction()

# fumage_icons(<SVG> <component>): as it is, and as PNG for desktops that draw none (needs rsvg-convert).
function(fumage_icons svg component)
    set(folder ${CMAKE_INSTALL_DATADIR}/icons/hicolor)
    install(FILES ${svg} DESTINATION ${folder}/scalable/apps COMPONENT ${component})
    find_program(RSVG_CONVERT rsvg-convert)
    if(NOT FUMAGE_BUILD_MANUAL OR NOT RSVG_CONVERT)
        return()
    endif()
    get_filename_component(name ${svg} NAME_WE)
    set(icons "")
    foreach(size 16 22 24 32 48 64 128 256 512)
        set(icon ${CMAKE_CURRENT_BINARY_DIR}/icons/${size}/${name}.png)
        file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/icons/${size})
        add_custom_command(OUTPUT ${icon} COMMAND ${RSVG_CONVERT} --width ${size} --height ${size} --output ${icon} ${svg}
            DEPENDS ${svg} COMMENT "Drawing the icon of ${size} pixels" VERBATIM)
        install(FILES ${icon} DESTINATION ${folder}/${size}x${size}/apps COMPONENT ${component})
        list(APPEND icons ${icon})
    endforeach()
    add_custom_target(${name}-icons ALL DEPENDS ${icons})
endfunction()

# fumage_handbook(<component>): the manual as the editor shows it, with the pages and the pictures that it links to, where its links find them.
function(fumage_handbook component)
    set(folder ${CMAKE_INSTALL_DATADIR}/fumage)
    set(resources ${PROJECT_SOURCE_DIR}/resources)
    install(DIRECTORY ${resources}/docs/manual DESTINATION ${folder}/docs COMPONENT ${component}
        FILES_MATCHING PATTERN "*.md" PATTERN "*.jpg" PATTERN "*.png" PATTERN "__pycache__" EXCLUDE)
    file(GLOB pages ${resources}/docs/*.md)
    install(FILES ${pages} DESTINATION ${folder}/docs COMPONENT ${component})
    install(FILES ${resources}/parameters.md DESTINATION ${folder} COMPONENT ${component})
    install(DIRECTORY ${resources}/pictures DESTINATION ${folder} COMPONENT ${component} FILES_MATCHING PATTERN "*.png")
    if(UNIX)
        # Where one looks for documents of programs.
        file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/documents)
        file(CREATE_LINK ../../fumage/docs ${PROJECT_BINARY_DIR}/documents/manual SYMBOLIC)
        install(FILES ${PROJECT_BINARY_DIR}/documents/manual DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/fumage COMPONENT ${component})
    endif()
endfunction()

# fumage_documents(<package> <component> [pages of resources/docs]...): licence, changelog and README, and what else concerns the package.
function(fumage_documents package component)
    set(folder ${CMAKE_INSTALL_DATADIR}/doc/${package})
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${folder} RENAME copyright COMPONENT ${component})
    set(made ${PROJECT_BINARY_DIR}/documents/${package})
    list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/resources/ OUTPUT_VARIABLE sources)
    set(documents "")
    foreach(page ${PROJECT_SOURCE_DIR}/README.md ${sources})
        get_filename_component(name ${page} NAME)
        list(APPEND documents ${made}/${name})
    endforeach()
    add_custom_command(OUTPUT ${documents} ${made}/changelog.gz ${made}/NEWS.md.gz
        COMMAND ${CMAKE_COMMAND} -E make_directory ${made}
        COMMAND bash ${PROJECT_SOURCE_DIR}/resources/manual/make_documents.sh ${PROJECT_VERSION} ${FUMAGE_MAINTAINER} ${PROJECT_SOURCE_DIR} ${made} ${sources}
        DEPENDS ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${sources}
            ${PROJECT_SOURCE_DIR}/resources/manual/make_documents.sh ${PROJECT_SOURCE_DIR}/resources/manual/make_changelog.sh
        COMMENT "Writing the documents of ${package}" VERBATIM)
    install(FILES ${documents} ${made}/changelog.gz ${made}/NEWS.md.gz DESTINATION ${folder} COMPONENT ${component} OPTIONAL)
    if(FUMAGE_BUILD_MANUAL)
        add_custom_target(${package}-documents ALL DEPENDS ${documents} ${made}/changelog.gz ${made}/NEWS.md.gz)
    endif()
endfunction()

# The pages that the editor shows (Help > Manual), which fumage_handbook() installs, seen from the program.
file(RELATIVE_PATH FUMAGE_MANUAL_FROM_PROGRAM "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_FULL_DATADIR}/fumage/docs")

# fumage_link_manual(): puts the pages into the build tree, as far from its programs as they are from those that are installed.
function(fumage_link_manual)
    set(pages ${PROJECT_SOURCE_DIR}/resources/docs)
    cmake_path(SET link NORMALIZE "${CMAKE_BINARY_DIR}/bin/${FUMAGE_MANUAL_FROM_PROGRAM}")
    cmake_path(IS_PREFIX CMAKE_BINARY_DIR "${link}" NORMALIZE is_inside)
    if(NOT is_inside OR NOT EXISTS ${pages})
        return()
    endif()
    cmake_path(GET link PARENT_PATH folder)
    file(MAKE_DIRECTORY ${folder})
    file(CREATE_LINK ${pages} ${link} RESULT failure SYMBOLIC)
    if(failure) # Windows lets not everybody make links
        file(COPY ${pages} DESTINATION ${folder})
    endif()
endfunction()
