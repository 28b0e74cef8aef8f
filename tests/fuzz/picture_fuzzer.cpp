// The first bytes of any file are no picture, a broken one, or have notes; what they carry is read like any preset. As
// the picture of an effect it is refused with a message, or has pixels, and only bright ones are found.

#include "tests/fuzz/expect.h"

#include "core/effect/bitmap.h"
#include "core/image_io/metadata_reader.h"
#include "core/preset/preset_file.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace {

void readForEffect(std::span<const std::byte> file)
{
    using namespace fumage;
    const Result<Bitmap> picture = Bitmap::read(file);
    if (!picture) {
        FUMAGE_EXPECT(!picture.error().message.empty() && !picture.error().remedy.empty());
        return;
    }
    const std::span<const std::uint8_t> pixels = picture.value().pixels();
    FUMAGE_EXPECT(pixels.size() / 4 <= std::size_t{kMaxPictureEdge} * kMaxPictureEdge);
    for (const std::uint32_t bits : {0U, 1U << 31U, ~0U}) {
        FUMAGE_EXPECT(!picture.value().isBright() || picture.value().brightPixel(bits) < pixels.size() / 4);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace fumage;
    readForEffect(std::as_bytes(std::span(data, size)));
    const std::string_view head(reinterpret_cast<const char*>(data), size);
    const Result<ImageMetadata> notes = readImageMetadata(head);
    if (!notes) {
        FUMAGE_EXPECT(!notes.error().message.empty());
        return 0;
    }
    FUMAGE_EXPECT(isPicture(head) && notes.value().preset.size() <= kMaxNoteBytes);
    (void)parsePreset(notes.value().preset);
    return 0;
}
