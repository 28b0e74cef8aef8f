// The first bytes of any file are no picture, a broken one, or have notes; what they carry is read like any preset.

#include "tests/fuzz/expect.h"

#include "core/picture_files/picture_notes.h"
#include "core/preset/preset.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace fumage;
    const std::string_view head(reinterpret_cast<const char*>(data), size);
    const Result<PictureNotes> notes = readPictureNotes(head);
    if (!notes) {
        FUMAGE_EXPECT(!notes.error().message.empty());
        return 0;
    }
    FUMAGE_EXPECT(isPicture(head) && notes.value().preset.size() <= kMostNoteBytes);
    (void)parsePreset(notes.value().preset);
    return 0;
}
