# Which libraries the tar brings along, for make_tar.sh and tests/package/check_tar.sh, which source this.
#
# The rule is that of AppImage's list of libraries to exclude (pkg2appimage's excludelist), with one difference: what it leaves
# out for the sake of the graphics drivers is brought along as a spare, and taken where the system has none.
# shellcheck shell=bash

# glibc: it belongs to the kernel and to ld.so of the system, and two in one program is one too many. Never brought along.
is_glibc() { # <name of a library>
    case $1 in
    ld-linux-*.so.* | libc.so.6 | libm.so.6 | libmvec.so.1 | libdl.so.2 | libpthread.so.0 | librt.so.1 | libresolv.so.2 | libutil.so.1 | libanl.so.1) return 0 ;;
    esac
    return 1
}

# Spares: what the system's drivers (Mesa with LLVM, NVIDIA) load into the same process. One name is loaded once: an older one of
# ours would take its symbols from a newer driver, which then does not start, and OpenGL with it. So the system's goes first.
is_spare() { # <name of a library>
    case $1 in
    # GL's dispatchers find the drivers of the system, X11's and Wayland's speak with its server.
    libGL.so.* | libEGL.so.* | libGLX.so.* | libOpenGL.so.* | libGLdispatch.so.* | libdrm.so.* | libgbm.so.*) return 0 ;;
    libX11.so.* | libX11-xcb.so.* | libXau.so.* | libXdmcp.so.* | libXext.so.* | libbsd.so.* | libmd.so.*) return 0 ;;
    libxcb.so.* | libxcb-glx.so.* | libxcb-randr.so.* | libxcb-shm.so.* | libxcb-sync.so.* | libxcb-xfixes.so.*) return 0 ;;
    libwayland-client.so.* | libwayland-cursor.so.* | libwayland-egl.so.*) return 0 ;;
    # What drivers and LLVM are linked with.
    libstdc++.so.* | libgcc_s.so.* | libffi.so.* | libexpat.so.* | libz.so.* | libzstd.so.* | liblzma.so.*) return 0 ;;
    # Not the drivers' but bound to the system all the same: the configuration and the cache of fonts are in its version's language.
    libfontconfig.so.* | libfreetype.so.*) return 0 ;;
    esac
    return 1
}

# What a program or library loads, with all that those load: a path a line.
libraries_of() { # <files>...
    local file
    for file in "$@"; do
        ldd "$file" 2> /dev/null || true # a plain script has none
    done | sed -n 's/.* => \(\/[^ ]*\) .*/\1/p' | sort -u
}

is_elf() { # <file>
    local start=
    LC_ALL=C IFS= read -r -n 4 -d '' start < "$1" || true
    [ "$start" = $'\x7fELF' ]
}

# All programs and libraries below folders, a path a line.
elf_files() { # <folders>...
    local file
    find "$@" -type f -print0 | while IFS= read -r -d '' file; do
        if is_elf "$file"; then printf '%s\n' "$file"; fi
    done
}

# The newest version of a family of symbols (GLIBC, GLIBCXX) that all files below folders ask others for.
symbol_floor() { # <family> <folders>...
    local family=$1 file
    shift
    elf_files "$@" | while IFS= read -r file; do
        readelf --version-info --wide "$file" | sed -n "s/.*Name: ${family}_\([0-9][0-9.]*\) .*/\1/p"
    done | sort -Vu | tail -1
}
