#include "core/export/sequence.h"

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/rendering/renderer.h"
#include "core/simulation/simulator.h"

#include <array>
#include <future>

namespace fumage {

namespace {

Status writeImage(const Image& image, const Effect& effect, ImageFormat format, const std::filesystem::path& path, const std::stop_token& stop)
{
    const Result<std::vector<std::byte>> bytes = encodeImage(image, effect.output, format, effect.timeline.frameRate, stop);
    if (!bytes) {
        Error error = bytes.error();
        error.place = path.string();
        return error;
    }
    return writeFileAtomically(path, bytes.value());
}

std::string padded(int number, std::size_t digits)
{
    std::string text = std::to_string(number);
    return text.size() >= digits ? text : std::string(digits - text.size(), '0') + text;
}

} // namespace

Result<FrameRange> parseFrameRange(std::string_view text)
{
    const Error malformed{ErrorCode::Syntax, said("frames %1 are not understood", inQuotes(text)), {}, said("Write 7, 0-119 or 0-119:2")};
    const std::string_view range = text.substr(0, text.find(':'));
    const std::string_view step = text.size() > range.size() ? text.substr(range.size() + 1) : "1";
    const std::size_t dash = range.find('-');
    const std::optional<std::int64_t> first = parseInteger(trimmed(range.substr(0, dash)));
    const std::optional<std::int64_t> last = dash == std::string_view::npos ? first : parseInteger(trimmed(range.substr(dash + 1)));
    const std::optional<std::int64_t> every = parseInteger(trimmed(step));
    if (!first || !last || !every) {
        return malformed;
    }
    if (*first < 0 || *last < *first || *last > kMaxFrame || *every < 1 || *every > kMaxFrame) {
        return Error{ErrorCode::OutOfRange, said("frames %1 run backwards or out of range", inQuotes(text)), {}, said("Use numbers from 0 to %1, the smaller first", kMaxFrame)};
    }
    return FrameRange{static_cast<int>(*first), static_cast<int>(*last), static_cast<int>(*every)};
}

std::filesystem::path framePath(const std::filesystem::path& output, const FrameRange& frames, std::string_view ending, int frame)
{
    constexpr std::size_t kDigits = 4;
    std::string name = withEnding(output, ending).filename().string();
    const std::size_t first = name.find('#');
    if (first != std::string::npos) {
        const std::size_t past = std::min(name.size(), name.find_first_not_of('#', first));
        name.replace(first, past - first, padded(frame, past - first));
    } else if (frames.count() > 1) {
        name.insert(name.size() - ending.size(), "_" + padded(frame, kDigits));
    }
    return output.parent_path() / name;
}

bool isFileOfAFrame(const std::filesystem::path& file, const std::filesystem::path& output, const FrameRange& frames, std::string_view ending)
{
    for (int i = 0; !file.empty() && i < frames.count(); ++i) {
        if (isSameFile(framePath(output, frames, ending, frames.at(i)), file)) {
            return true;
        }
    }
    return false;
}

std::filesystem::path framePath(const SequenceOptions& options, int frame)
{
    return framePath(options.output, options.frames, fileEnding(options.format), frame);
}

Result<std::vector<std::byte>> encodeFrame(const Effect& effect, int frame, ImageFormat format, const std::stop_token& stop, const Progress& progress)
{
    const SampledEffect smoke = sampled(effect);
    const Result<std::shared_ptr<const Frame>> simulated = Simulator(smoke).frame(frame, stop, progress);
    if (!simulated) {
        return simulated.error();
    }
    Image image;
    if (const Status status = Renderer().render(*simulated.value(), smoke, effect.output.width, effect.output.height, image, stop); !status) {
        return status.error();
    }
    return encodeImage(image, effect.output, format, effect.timeline.frameRate, stop);
}

Status renderSequence(const Effect& effect, const SequenceOptions& options, const Progress& progress, const std::stop_token& stop)
{
    if (Status status = makeFolderOf(options.output); !status) {
        return status;
    }
    const SampledEffect smoke = sampled(effect);
    Simulator simulator(smoke);
    Renderer renderer;
    std::array<Image, 2> images;
    std::future<Status> writing;
    const int total = options.frames.count();
    const auto finishWriting = [&]() -> Status { return writing.valid() ? writing.get() : Status(Done{}); };
    for (int done = 0; done < total; ++done) {
        const int number = options.frames.at(done);
        const Result<std::shared_ptr<const Frame>> frame = simulator.frame(number, stop, progress);
        if (!frame) {
            return frame.error();
        }
        Image& image = images[static_cast<std::size_t>(done % 2)];
        if (Status status = renderer.render(*frame.value(), smoke, effect.output.width, effect.output.height, image, stop); !status) {
            return status;
        }
        if (Status status = finishWriting(); !status) {
            return status;
        }
        if (done > 0) {
            progress(Work::Frames, done, total);
        }
        writing = std::async(std::launch::async, [&image, &effect, &stop, format = options.format, path = framePath(options, number)] { return writeImage(image, effect, format, path, stop); });
    }
    if (Status status = finishWriting(); !status) {
        return status;
    }
    progress(Work::Frames, total, total);
    return Done{};
}

} // namespace fumage
