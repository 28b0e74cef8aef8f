// The first bytes of any file are no picture, a broken one, or have notes; what they carry is read like any preset.

#include "tests/fuzz/expect.h"

#include "core/image_io/metadata_reader.h"
#include "core/preset/preset_file.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace fumage;
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
