#include "core/picture_files/picture_notes.h"

#include "core/picture_files/exr_file.h"
#include "core/picture_files/png_file.h"

namespace fumage {

namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kExrSignature = "\x76\x2f\x31\x01";

} // namespace

bool isPicture(std::string_view head)
{
    return head.starts_with(kPngSignature) || head.starts_with(kExrSignature);
}

Result<PictureNotes> readPictureNotes(std::string_view head)
{
    if (head.starts_with(kPngSignature)) {
        return readPngNotes(head);
    }
    if (head.starts_with(kExrSignature)) {
        return readExrNotes(head);
    }
    return Error{ErrorCode::Syntax, said("this is neither a PNG nor an EXR"), {}, {}};
}

} // namespace fumage
