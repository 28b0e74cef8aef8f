#include "core/image_io/metadata_reader.h"

#include "core/image_io/exr_file.h"
#include "core/image_io/png_chunks.h"
#include "core/image_io/png_file.h"

namespace fumage {

Result<ImageMetadata> readImageMetadata(const PartReader& file)
{
    constexpr std::size_t kSignatureBytes = 8;
    const Result<std::string> head = file(0, kSignatureBytes);
    if (!head) {
        return head.error();
    }
    switch (kindOf(head.value())) {
    case PictureKind::Png: {
        const Result<PngTexts> texts = textsOfPng(file);
        return texts ? readPngNotes(texts.value()) : texts.error();
    }
    case PictureKind::Exr: {
        const Result<std::string> beginning = file(0, kPictureHead);
        return beginning ? readExrNotes(beginning.value()) : beginning.error();
    }
    case PictureKind::Tga: return ImageMetadata{};
    case PictureKind::None: break;
    }
    return Error{ErrorCode::Syntax, makeMessage("this is neither a PNG nor an EXR"), {}, {}};
}

Result<ImageMetadata> readImageMetadata(std::string_view file)
{
    return readImageMetadata(partsOf(file));
}

} // namespace fumage
