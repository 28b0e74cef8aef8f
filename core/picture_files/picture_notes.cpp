#include "core/picture_files/picture_notes.h"

#include "core/picture_files/exr_file.h"
#include "core/picture_files/png_file.h"

namespace fumage {

namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kExrSignature = "\x76\x2f\x31\x01";
// TGA begins with what it holds: no text, no palette, and grey or colours in runs.
constexpr std::string_view kGreyTga("\0\0\3\0\0\0\0\0", 8);
constexpr std::string_view kColourTga("\0\0\n\0\0\0\0\0", 8);

bool isTga(std::string_view head)
{
    return head.starts_with(kGreyTga) || head.starts_with(kColourTga);
}

} // namespace

PictureKind kindOf(std::string_view head)
{
    return head.starts_with(kPngSignature) ? PictureKind::Png : head.starts_with(kExrSignature) ? PictureKind::Exr
        : isTga(head)                                                                           ? PictureKind::Tga
                                                                                                : PictureKind::None;
}

bool isPicture(std::string_view head)
{
    return kindOf(head) != PictureKind::None;
}

Result<PictureNotes> readPictureNotes(std::string_view head)
{
    switch (kindOf(head)) {
    case PictureKind::Png: return readPngNotes(head);
    case PictureKind::Exr: return readExrNotes(head);
    case PictureKind::Tga: return PictureNotes{};
    case PictureKind::None: break;
    }
    return Error{ErrorCode::Syntax, said("this is neither a PNG nor an EXR"), {}, {}};
}

} // namespace fumage
