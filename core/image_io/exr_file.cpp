#include "core/image_io/exr_file.h"

#include "core/version.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfIO.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <openexr.h>

namespace fumage {

namespace {

/// A stream of OpenEXR into memory; it seeks back to fill in its table of offsets.
class MemoryStream : public Imf::OStream {
public:
    MemoryStream()
        : Imf::OStream("memory")
    {
    }
    void write(const char data[], int count) override
    {
        const auto size = static_cast<std::size_t>(count);
        if (m_at + size > m_bytes.size()) {
            m_bytes.resize(m_at + size);
        }
        std::memcpy(m_bytes.data() + m_at, data, size);
        m_at += size;
    }
    std::uint64_t tellp() override { return m_at; }
    void seekp(std::uint64_t position) override { m_at = position; }

    [[nodiscard]] std::vector<std::byte> take() { return std::move(m_bytes); }

private:
    std::vector<std::byte> m_bytes;
    std::size_t m_at = 0;
};

/// The same to read from, a part at a time.
class PartStream : public Imf::IStream {
public:
    explicit PartStream(const PartReader& file)
        : Imf::IStream("file")
        , m_file(file)
    {
    }
    bool read(char to[], int count) override
    {
        auto size = static_cast<std::size_t>(count);
        while (size > 0) {
            if (m_at < m_begin || m_at >= m_begin + m_part.size()) {
                fetch();
            }
            const std::size_t within = static_cast<std::size_t>(m_at - m_begin);
            const std::size_t some = std::min(size, m_part.size() - within);
            std::memcpy(to, m_part.data() + within, some);
            to += some; // NOLINT(cppcoreguidelines-pro-bounds-pointer-arithmetic)
            m_at += some;
            size -= some;
        }
        return true; // whether more follows, the next reading tells
    }
    std::uint64_t tellg() override { return m_at; }
    void seekg(std::uint64_t position) override { m_at = position; }

    /// Why the file could not be read, where it is not the picture that is to blame.
    [[nodiscard]] const std::optional<Error>& failure() const { return m_failure; }

private:
    void fetch()
    {
        constexpr std::size_t kPart = std::size_t{1} << 16U;
        Result<std::string> part = m_file(m_at, kPart);
        if (!part) {
            m_failure = part.error();
        }
        if (!part || part.value().empty()) {
            throw std::runtime_error("it ends too soon"); // as this library wants it; caught in readExrParts()
        }
        m_part = std::move(part).value();
        m_begin = m_at;
    }

    const PartReader& m_file;
    std::string m_part;
    std::uint64_t m_begin = 0; ///< of the part
    std::uint64_t m_at = 0;
    std::optional<Error> m_failure;
};

/// The attribute that has a part of a note, counted from 1.
std::string partOfNote(std::string_view note, std::size_t number)
{
    return std::string(note) + "." + std::to_string(number);
}

/// A note in parts that every reader can skip.
void insertNote(std::string_view note, std::string_view text, Imf::Header& header)
{
    const auto isContinuation = [](char letter) { return (static_cast<unsigned char>(letter) & 0xC0U) == 0x80U; };
    for (std::size_t number = 1; !text.empty(); ++number) {
        std::size_t length = std::min(text.size(), kMaxExrTextBytes);
        while (length > 1 && length < text.size() && isContinuation(text[length])) {
            --length; // readers may take each part for UTF-8
        }
        header.insert(partOfNote(note, number), Imf::StringAttribute(std::string(text.substr(0, length))));
        text.remove_prefix(length);
    }
}

void describePreset(const ImageMetadata& notes, Imf::Header& header)
{
    insertNote(kPresetNote, notes.preset, header);
    insertNote(kSheetNote, notes.sheet, header);
    header.insert(kFrameNote.data(), Imf::IntAttribute(notes.frame));
}

/// Says what the numbers mean: linear light in the primaries of Rec. 709 and sRGB, which are those that readers take
/// where nothing is said.
void describe(const ExrPixels& pixels, Imf::Header& header)
{
    header.insert("software", Imf::StringAttribute("Fumage " FUMAGE_VERSION));
    if (!pixels.isLight) {
        header.insert("comments", Imf::StringAttribute("linear data, not colours"));
    } else if (pixels.targets.front().channels.size() > 1) {
        Imf::addChromaticities(header, Imf::Chromaticities());
    }
    if (pixels.notes.frameRate > 0) {
        Imf::addFramesPerSecond(header, Imf::Rational(pixels.notes.frameRate, 1));
    }
    if (!pixels.notes.preset.empty()) {
        describePreset(pixels.notes, header);
    }
}

template <class Sample>
void writeExr(const ExrPixels& pixels, Imf::PixelType type, MemoryStream& stream, const std::stop_token& stop)
{
    std::vector<std::vector<Sample>> samples; // until the file is written
    Imf::Header header(pixels.width, pixels.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    describe(pixels, header);
    Imf::FrameBuffer buffer;
    for (const ExrChannels& target : pixels.targets) {
        samples.emplace_back(target.values.begin(), target.values.end());
        const std::size_t pixelStride = sizeof(Sample) * target.channels.size();
        for (std::size_t i = 0; i < target.channels.size(); ++i) {
            const std::string name = (target.name.empty() ? "" : target.name + ".") + target.channels[i];
            header.channels().insert(name, Imf::Channel(type));
            buffer.insert(name,
                Imf::Slice(type, reinterpret_cast<char*>(samples.back().data() + i), pixelStride,
                    pixelStride * static_cast<std::size_t>(pixels.width)));
        }
    }
    // No threads of its own: pictures are written beside one another.
    Imf::OutputFile file(stream, header, 0);
    file.setFrameBuffer(buffer);
    constexpr int kRowsAtOnce = 64; // whole blocks of the compression
    for (int row = 0; row < pixels.height && !stop.stop_requested(); row += kRowsAtOnce) {
        file.writePixels(std::min(kRowsAtOnce, pixels.height - row));
    }
}

/// Whether so many channels are read; some have fewer numbers than pixels, which we never write.
Status checkShape(std::int64_t width, std::int64_t height, const Imf::ChannelList& channels)
{
    std::int64_t count = 0;
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1) {
            return Error{ErrorCode::Syntax,
                makeMessage("a channel of the picture has fewer numbers than there are pixels"), {}, {}};
        }
        ++count;
    }
    const auto most = static_cast<std::int64_t>(kMaxReadPixels);
    if (width < 1 || height < 1 || width > most || height > most || width * height > most
        || width * height * count > static_cast<std::int64_t>(kMaxReadNumbers)) {
        return Error{ErrorCode::TooLarge, makeMessage("a picture of %1 x %2 pixels", width, height), {}, {}};
    }
    return Done{};
}

constexpr std::size_t kNumbersAtOnce = std::size_t{1} << 22U; ///< 16 MiB of them

using ChannelSink = std::function<void(const std::string& channel, std::span<const float> part)>;

/// Reads rows of some channels, and hands them out one after the other.
void readSome(Imf::InputFile& file, std::span<const std::string> channels, int firstRow, int rows,
    std::vector<std::vector<float>>& numbers, const ChannelSink& sink)
{
    const Imath::Box2i window = file.header().dataWindow();
    const int width = window.max.x - window.min.x + 1;
    const std::size_t rowStride = sizeof(float) * static_cast<std::size_t>(width);
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        numbers[i].resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(rows));
        buffer.insert(channels[i],
            Imf::Slice::Make(
                Imf::FLOAT, numbers[i].data(), {window.min.x, firstRow}, width, rows, sizeof(float), rowStride));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(firstRow, firstRow + rows - 1);
    for (std::size_t i = 0; i < channels.size(); ++i) {
        sink(channels[i], numbers[i]);
    }
}

Status readChannels(
    Imf::InputFile& file, const std::function<void(int width, int height)>& begin, const ChannelSink& sink)
{
    const Imath::Box2i window = file.header().dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    const Imf::ChannelList& list = file.header().channels();
    if (Status status = checkShape(width, height, list); !status) {
        return status;
    }
    begin(static_cast<int>(width), static_cast<int>(height));
    std::vector<std::string> names;
    for (auto channel = list.begin(); channel != list.end(); ++channel) {
        names.emplace_back(channel.name());
    }
    // As many whole channels as there is room for, or one in as many rows.
    const auto pixels = static_cast<std::size_t>(width * height);
    const std::size_t atOnce = std::max<std::size_t>(1, kNumbersAtOnce / pixels);
    const int rows = pixels <= kNumbersAtOnce
        ? static_cast<int>(height)
        : std::max(1, static_cast<int>(kNumbersAtOnce / static_cast<std::size_t>(width)));
    std::vector<std::vector<float>> numbers(atOnce);
    for (std::size_t first = 0; first < names.size(); first += atOnce) {
        const std::span<const std::string> some =
            std::span(names).subspan(first, std::min(atOnce, names.size() - first));
        for (int row = 0; row < height; row += rows) {
            readSome(file, some, window.min.y + row, std::min(rows, static_cast<int>(height) - row), numbers, sink);
        }
    }
    return Done{};
}

/// A callback of OpenEXR's C library, which has no limits but those of what it reads from.
std::int64_t readHead(exr_const_context_t /*context*/, void* user, void* to, std::uint64_t size, std::uint64_t at,
    exr_stream_error_func_ptr_t /*error*/)
{
    const auto& head = *static_cast<const std::string_view*>(user);
    const std::uint64_t count = at < head.size() ? std::min<std::uint64_t>(size, head.size() - at) : 0;
    if (count > 0) {
        std::memcpy(to, head.data() + at, count);
    }
    return static_cast<std::int64_t>(count);
}

/// What an attribute says that it holds, and does not, is found by the size of the file.
std::int64_t sizeOfHead(exr_const_context_t /*context*/, void* user)
{
    return static_cast<std::int64_t>(static_cast<const std::string_view*>(user)->size());
}

void ignore(exr_const_context_t /*context*/, exr_result_t /*code*/, const char* /*message*/) { }

/// Nothing where there is no such attribute.
std::optional<std::string_view> textOf(exr_const_context_t file, const std::string& name)
{
    const char* text = nullptr;
    std::int32_t length = 0;
    const bool found = exr_attr_get_string(file, 0, name.c_str(), &length, &text) == EXR_ERR_SUCCESS && length > 0;
    return found ? std::optional(std::string_view(text, static_cast<std::size_t>(length))) : std::nullopt;
}

/// All of a note, be it in parts or, as it was once written, in one; at most a byte more than is read.
std::string noteOf(exr_const_context_t file, std::string_view note)
{
    std::string whole(textOf(file, std::string(note)).value_or(std::string_view()));
    for (std::size_t number = 1; whole.size() <= kMaxNoteBytes; ++number) {
        const std::optional<std::string_view> part = textOf(file, partOfNote(note, number));
        if (!part) {
            break;
        }
        whole += *part;
    }
    return whole.substr(0, kMaxNoteBytes + 1);
}

ImageMetadata notesOf(exr_const_context_t file)
{
    ImageMetadata notes;
    notes.preset = noteOf(file, kPresetNote);
    notes.sheet = noteOf(file, kSheetNote);
    std::int32_t frame = 0;
    if (exr_attr_get_int(file, 0, kFrameNote.data(), &frame) == EXR_ERR_SUCCESS) {
        notes.frame = frame;
    }
    return notes;
}

} // namespace

std::string exrChannels(int count)
{
    return count == 1 ? "Y" : count == 3 ? "RGB" : "RGBA";
}

Result<std::vector<std::byte>> encodeExr(const ExrPixels& pixels, const std::stop_token& stop)
{
    try {
        MemoryStream stream;
        if (pixels.half) {
            writeExr<half>(pixels, Imf::HALF, stream, stop);
        } else {
            writeExr<float>(pixels, Imf::FLOAT, stream, stop);
        }
        if (stop.stop_requested()) {
            return Error{ErrorCode::Cancelled, makeMessage("the picture was cancelled"), {}, {}};
        }
        return stream.take();
    } catch (const std::exception& cause) {
        return Error{
            ErrorCode::WriteFailed, makeMessage("the picture cannot be written as EXR: %1", cause.what()), {}, {}};
    }
}

Result<ImageMetadata> readExrNotes(std::string_view head)
{
    exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
    start.error_handler_fn = ignore;
    start.user_data = &head;
    start.read_fn = readHead;
    start.size_fn = sizeOfHead;
    exr_context_t file = nullptr;
    const exr_result_t opened = exr_start_read(&file, "memory", &start);
    if (opened != EXR_ERR_SUCCESS) {
        return Error{
            ErrorCode::Syntax, makeMessage("the picture is broken: %1", exr_get_default_error_message(opened)), {}, {}};
    }
    const ImageMetadata notes = notesOf(file);
    exr_finish(&file);
    return notes.preset.size() > kMaxNoteBytes || notes.sheet.size() > kMaxNoteBytes ? damagedNote()
                                                                                     : Result<ImageMetadata>(notes);
}

Status readExrParts(
    const PartReader& file, const std::function<void(int width, int height)>& begin, const ChannelSink& part)
{
    PartStream stream(file);
    try {
        Imf::InputFile input(stream, 0);
        return readChannels(input, begin, part);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, makeMessage("there is not enough memory"), {}, {}};
    } catch (const std::exception& cause) {
        return stream.failure()
            ? *stream.failure()
            : Error{ErrorCode::Syntax, makeMessage("the picture is broken: %1", cause.what()), {}, {}};
    }
}

Result<ExrNumbers> readExr(std::span<const std::byte> file)
{
    ExrNumbers numbers;
    const auto begin = [&](int width, int height) {
        numbers.width = width;
        numbers.height = height;
    };
    const auto keep = [&](const std::string& channel, std::span<const float> part) {
        if (numbers.channels.empty() || numbers.channels.back().name != channel) {
            numbers.channels.push_back({channel, {}});
        }
        std::vector<float>& values = numbers.channels.back().values;
        values.insert(values.end(), part.begin(), part.end());
    };
    const Status status = readExrParts(partsOf({reinterpret_cast<const char*>(file.data()), file.size()}), begin, keep);
    return status ? Result<ExrNumbers>(std::move(numbers)) : status.error();
}

} // namespace fumage
