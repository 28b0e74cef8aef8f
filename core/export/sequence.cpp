#include "core/export/sequence.h"

#include "core/system/file.h"
#include "core/system/path.h"
#include "core/base/text.h"
#include "core/export/layer_masks.h"
#include "core/export/pass_frames.h"
#include "core/export/frame_neighbours.h"
#include "core/export/output_name.h"
#include "core/rendering/scene_renderer.h"

#include <algorithm>
#include <array>
#include <future>

namespace fumage {

namespace {

std::string padded(int number, std::size_t digits)
{
    std::string text = std::to_string(number);
    return text.size() >= digits ? text : std::string(digits - text.size(), '0') + text;
}

ImageMetadata notesOf(const Scene& scene, const SequenceOptions& options, int frame)
{
    return {scene.timeline.frameRate, options.preset, frame};
}

bool hasTargets(const SequenceOptions& options)
{
    return options.passes != PassSet{Pass::Colour};
}

Status check(const Scene& scene, const SequenceOptions& options)
{
    return hasTargets(options) ? checkTargets(scene, options.passes, options.format) : Status(Done{});
}

/// Frames of which the colour is written. Two are kept: one is encoded while the next is made.
class ColourFrames {
public:
    ColourFrames(const Scene& scene, const SequenceOptions& options, std::vector<int> numbers,
        const std::shared_ptr<AirCache>& shelf)
        : m_scene(scene)
        , m_options(options)
        , m_numbers(std::move(numbers))
        , m_renderer(scene, shelf)
    {
    }

    [[nodiscard]] Status render(std::size_t place, const Task& task)
    {
        const Output& output = m_scene.output;
        return m_renderer.render(m_numbers[place], output.width, output.height, m_images[place % 2], task);
    }
    [[nodiscard]] Result<std::vector<std::byte>> encode(std::size_t place, const std::stop_token& stop) const
    {
        return encodeImage(m_images[place % 2], m_scene.atFrame(m_numbers[place]), m_options.format,
            notesOf(m_scene, m_options, m_numbers[place]), stop);
    }

private:
    Scene m_scene;
    SequenceOptions m_options;
    std::vector<int> m_numbers;
    SceneRenderer m_renderer;
    std::array<Image, 2> m_images;
};

/// The same for all passes, as targets.
class PassFrames {
public:
    PassFrames(const Scene& scene, const SequenceOptions& options, std::vector<int> numbers,
        const std::shared_ptr<AirCache>& shelf)
        : m_scene(scene)
        , m_layers(sampledLayers(scene))
        , m_options(options)
        , m_frames{std::move(numbers)}
        , m_neighbours(m_layers, m_frames, options.passes.has(Pass::Motion), options.frames.step, shelf)
        , m_masks(scene)
    {
        m_options.passes.add(Pass::Colour);
        for (PassSheet& sheet : m_sheets) {
            sheet.grid = {1, 1, m_scene.output.width, m_scene.output.height};
        }
    }
    PassFrames(const PassFrames&) = delete; // what hands out frames looks at the numbers
    PassFrames& operator=(const PassFrames&) = delete;

    [[nodiscard]] Status render(std::size_t place, const Task& task)
    {
        const Result<FrameAmongOthers> frame = m_neighbours.at(place, task);
        if (!frame) {
            return frame.error();
        }
        PassSheet& sheet = m_sheets[place % 2];
        Status status = m_renderer.render(
            frame.value(), sheet.grid.cellWidth, sheet.grid.cellHeight, m_options.passes, sheet.targets, task.stop);
        return status && m_options.passes.has(Pass::LayerMasks) ? m_masks.place(sheet, 0,
                   sheet.targets.of(PassTarget::Colour), m_scene.output.supersample, m_renderer.layers(), task.stop)
                                                                : status;
    }
    [[nodiscard]] Result<std::vector<std::byte>> encode(std::size_t place, const std::stop_token& stop) const
    {
        return encodeTargets(m_sheets[place % 2], m_options.passes, m_options.premultiplied,
            m_scene.atFrame(m_frames.numbers[place]).output, m_options.format,
            notesOf(m_scene, m_options, m_frames.numbers[place]), stop);
    }

private:
    Scene m_scene;
    std::vector<SampledEffect> m_layers;
    SequenceOptions m_options;
    CellFrames m_frames;
    FrameNeighbours m_neighbours;
    PassRenderer m_renderer;
    LayerMasks m_masks;
    std::array<PassSheet, 2> m_sheets;
};

template <class Frames>
Status encodeEach(Frames frames, const SequenceOptions& options, const std::vector<int>& numbers, const FrameSink& sink,
    const Task& task)
{
    std::future<Status> taking;
    const auto finishTaking = [&]() -> Status { return taking.valid() ? taking.get() : Status(Done{}); };
    const int total = static_cast<int>(numbers.size());
    for (int done = 0; done < total; ++done) {
        const auto place = static_cast<std::size_t>(done);
        if (Status status = frames.render(place, task); !status) {
            return status;
        }
        if (Status status = finishTaking(); !status) {
            return status;
        }
        if (done > 0) {
            task.progress(ProgressPhase::Frames, done, total);
        }
        taking = std::async(
            std::launch::async, [&frames, &options, &sink, &task, place, frame = numbers[place]]() -> Status {
                const Result<std::vector<std::byte>> bytes = frames.encode(place, task.stop);
                if (!bytes) {
                    Error error = bytes.error();
                    error.place = framePath(options, frame).string();
                    return error;
                }
                return sink(frame, bytes.value());
            });
    }
    if (Status status = finishTaking(); !status) {
        return status;
    }
    task.progress(ProgressPhase::Frames, total, total);
    return Done{};
}

} // namespace

std::vector<int> numbersOf(const FrameRange& frames)
{
    std::vector<int> numbers;
    for (int i = 0; i < frames.count(); ++i) {
        numbers.push_back(frames.at(i));
    }
    return numbers;
}

Result<FrameRange> parseFrameRange(std::string_view text)
{
    const Error malformed{ErrorCode::Syntax, makeMessage("invalid frame range %1", inQuotes(text)), {},
        makeMessage("Write 7, 0-119 or 0-119:2")};
    const std::string_view range = text.substr(0, text.find(':'));
    const std::string_view step = text.size() > range.size() ? text.substr(range.size() + 1) : "1";
    const std::size_t dash = range.find('-');
    const std::optional<std::int64_t> first = parseInteger(trimmed(range.substr(0, dash)));
    const std::optional<std::int64_t> last =
        dash == std::string_view::npos ? first : parseInteger(trimmed(range.substr(dash + 1)));
    const std::optional<std::int64_t> every = parseInteger(trimmed(step));
    if (!first || !last || !every) {
        return malformed;
    }
    if (*first < 0 || *last < *first || *last > kMaxFrame || *every < 1 || *every > kMaxFrame) {
        return Error{ErrorCode::OutOfRange, makeMessage("frames %1 run backwards or out of range", inQuotes(text)), {},
            makeMessage("Use numbers from 0 to %1, the smaller first", kMaxFrame)};
    }
    return FrameRange{static_cast<int>(*first), static_cast<int>(*last), static_cast<int>(*every)};
}

std::string textOf(const FrameRange& frames)
{
    const std::string first = std::to_string(frames.first);
    const std::string range = frames.last == frames.first ? first : first + "-" + std::to_string(frames.last);
    return frames.step == 1 ? range : range + ":" + std::to_string(frames.step);
}

std::filesystem::path framePath(
    const std::filesystem::path& output, const FrameRange& frames, std::string_view ending, int frame)
{
    constexpr std::size_t kDigits = 4;
    std::string name = withEnding(output, ending).filename().string();
    if (const std::optional<NumberPlace> place = numberPlaceIn(name)) {
        name.replace(place->at, place->length, padded(frame, place->digits));
    } else if (frames.count() > 1) {
        name.insert(name.size() - ending.size(), "_" + padded(frame, kDigits));
    }
    return output.parent_path() / pathFrom(name);
}

bool isFileOfAFrame(const std::filesystem::path& file, const std::filesystem::path& output, const FrameRange& frames,
    std::string_view ending)
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
    return options.isNumbered ? framePath(options.output, options.frames, fileEnding(options.format), frame)
                              : withEnding(options.output, fileEnding(options.format));
}

std::vector<int> numbersOf(const SequenceOptions& options)
{
    std::vector<int> numbers = numbersOf(options.frames);
    std::erase_if(numbers,
        [&](int number) { return std::binary_search(options.leftOut.begin(), options.leftOut.end(), number); });
    return numbers;
}

Result<std::vector<std::byte>> encodeFrame(
    const Scene& scene, int frame, const SequenceOptions& options, const ExportTask& task)
{
    const auto encoded = [&](auto frames) -> Result<std::vector<std::byte>> {
        const Status status = frames.render(0, task);
        return status ? frames.encode(0, task.stop) : status.error();
    };
    if (Status status = check(scene, options); !status) {
        return status.error();
    }
    return hasTargets(options) ? encoded(PassFrames(scene, options, {frame}, task.shelf))
                               : encoded(ColourFrames(scene, options, {frame}, task.shelf));
}

Status writeNumbered(
    const NumberedFiles& files, const std::function<Result<std::string>(int frame)>& bytesOf, const Task& task)
{
    if (isFileOfAFrame(files.source, files.output, files.frames, files.ending)) {
        return wouldOverwrite(files.source);
    }
    if (Status status = makeFolderOf(files.output); !status) {
        return status;
    }
    for (int done = 0; done < files.frames.count(); ++done) {
        const int frame = files.frames.at(done);
        const Result<std::string> bytes = bytesOf(frame);
        if (!bytes) {
            return bytes.error();
        }
        Status status = writeFileAtomically(framePath(files.output, files.frames, files.ending, frame), bytes.value());
        status = status && files.written ? files.written(frame, std::as_bytes(std::span(bytes.value()))) : status;
        if (!status) {
            return status;
        }
        task.progress(ProgressPhase::Frames, done + 1, files.frames.count());
    }
    return Done{};
}

Status encodeFrames(const Scene& scene, const SequenceOptions& options, const FrameSink& sink, const ExportTask& task)
{
    if (Status status = check(scene, options); !status) {
        return status;
    }
    const std::vector<int> numbers = numbersOf(options);
    if (numbers.empty()) {
        return Done{};
    }
    if (hasTargets(options)) {
        return encodeEach(PassFrames(scene, options, numbers, task.shelf), options, numbers, sink, task);
    }
    return encodeEach(ColourFrames(scene, options, numbers, task.shelf), options, numbers, sink, task);
}

Status renderSequence(const Scene& scene, const SequenceOptions& options, const ExportTask& task)
{
    if (Status status = check(scene, options); !status) {
        return status;
    }
    if (Status status = makeFolderOf(options.output); !status) {
        return status;
    }
    const auto write = [&](int frame, std::span<const std::byte> bytes) -> Status {
        Status status = writeFileAtomically(framePath(options, frame), bytes);
        return status && options.written ? options.written(frame, bytes) : status;
    };
    return encodeFrames(scene, options, write, task);
}

} // namespace fumage
