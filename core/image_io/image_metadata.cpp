#include "core/image_io/image_metadata.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace fumage {

namespace {

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
    return head.starts_with(kPngSignature) ? PictureKind::Png
        : head.starts_with(kExrSignature)  ? PictureKind::Exr
        : isTga(head)                      ? PictureKind::Tga
                                           : PictureKind::None;
}

bool isPicture(std::string_view head)
{
    return kindOf(head) != PictureKind::None;
}

PartReader partsOf(std::string_view bytes)
{
    return [bytes](std::uint64_t at, std::size_t size) -> Result<std::string> {
        return std::string(bytes.substr(std::min<std::uint64_t>(at, bytes.size()), size));
    };
}

Error damagedNote()
{
    return {ErrorCode::Syntax,
        makeMessage("the preset that this picture carries is damaged, or longer than the %1 bytes that are read",
            kMaxNoteBytes),
        {}, makeMessage("Choose another picture, or the preset's own file")};
}

std::string asciiJson(std::string_view json)
{
    std::string out;
    const auto isAscii = [](char letter) { return static_cast<unsigned char>(letter) < 0x80U; };
    for (auto at = json.begin(); at != json.end();) {
        const auto plain = std::find_if_not(at, json.end(), isAscii);
        out.append(at, plain);
        at = std::find_if(plain, json.end(), isAscii);
        const std::string quoted =
            nlohmann::json(std::string(plain, at)).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
        out.append(quoted, 1, quoted.size() - 2);
    }
    return out;
}

} // namespace fumage
