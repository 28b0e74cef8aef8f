// The text of a range of frames is either refused with a message, or names frames in order from 0 to the largest; and
// each has a file of its own.

#include "tests/fuzz/expect.h"

#include "core/export/sequence.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace fumage;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const Result<FrameRange> range = parseFrameRange(text);
    if (!range) {
        FUMAGE_EXPECT(!range.error().message.empty());
        return 0;
    }
    const FrameRange frames = range.value();
    const int last = frames.at(frames.count() - 1);
    FUMAGE_EXPECT(frames.first >= 0 && frames.step >= 1 && frames.count() >= 1);
    FUMAGE_EXPECT(last >= frames.first && last <= frames.last && frames.last <= kMaxFrame);
    const std::string name(text.substr(0, text.find('\0')));
    for (const std::string& output : {name, "a/" + name + "##.png", name + "_####"}) {
        const SequenceOptions options{output, frames, ImageFormat::Png8};
        FUMAGE_EXPECT(frames.count() == 1 || framePath(options, frames.first) != framePath(options, last));
    }
    return 0;
}
