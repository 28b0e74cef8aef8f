#include "core/export/frame_source.h"

#include "core/system/file.h"
#include "core/export/manifest/manifest.h"
#include "core/image_io/exr_file.h"

#include <algorithm>
#include <array>

namespace fumage {

namespace {

constexpr std::size_t kMaxFrameBytes = std::size_t{4} << 30U;

/// Puts four channels side by side. @return whether they are there
bool interleave(const ExrNumbers& numbers, Image& image)
{
    static constexpr std::array kColours{"R", "G", "B", "A"};
    for (std::size_t i = 0; i < kColours.size(); ++i) {
        const auto channel = std::ranges::find(numbers.channels, kColours[i], &ExrNumbers::Channel::name);
        if (channel == numbers.channels.end()) {
            return false;
        }
        for (std::size_t pixel = 0; pixel < channel->values.size(); ++pixel) {
            image.pixels[4 * pixel + i] = channel->values[pixel];
        }
    }
    return true;
}

Status read(const std::filesystem::path& file, int width, int height, Image& image)
{
    const Result<std::string> bytes = readFile(file, kMaxFrameBytes);
    if (!bytes) {
        return bytes.error();
    }
    const Result<ExrNumbers> numbers = readExr(std::as_bytes(std::span(bytes.value())));
    if (!numbers) {
        Error error = numbers.error();
        error.place = file.string();
        return error;
    }
    image.resize(width, height);
    if (numbers.value().width != width || numbers.value().height != height || !interleave(numbers.value(), image)) {
        return Error{ErrorCode::WrongType,
            makeMessage("this is no picture of %1 x %2 pixels with colour and alpha", width, height), file.string(),
            makeMessage("Render the frames anew, as EXR and in the preset's size")};
    }
    return Done{};
}

} // namespace

FrameSource framesOfFiles(const std::filesystem::path& output, const FrameRange& frames, int width, int height)
{
    return [=](int frame, Image& image) {
        return read(framePath(output, frames, fileEnding(ImageFormat::ExrHalf), frame), width, height, image);
    };
}

} // namespace fumage
