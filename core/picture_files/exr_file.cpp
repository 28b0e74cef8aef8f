#include "core/picture_files/exr_file.h"

#include "core/version.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
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

/// The same to read from.
class MemorySource : public Imf::IStream {
public:
    explicit MemorySource(std::span<const std::byte> bytes)
        : Imf::IStream("memory")
        , m_bytes(bytes)
    {
    }
    bool read(char to[], int count) override
    {
        const auto size = static_cast<std::size_t>(count);
        if (m_at > m_bytes.size() || size > m_bytes.size() - m_at) {
            throw std::runtime_error("it ends too soon"); // as this library wants it; caught in readExr()
        }
        std::memcpy(to, m_bytes.data() + m_at, size);
        m_at += size;
        return m_at < m_bytes.size();
    }
    std::uint64_t tellg() override { return m_at; }
    void seekg(std::uint64_t position) override { m_at = position; }

private:
    std::span<const std::byte> m_bytes;
    std::uint64_t m_at = 0;
};

/// Says what the numbers mean: linear light in the primaries of Rec. 709 and sRGB, which are those that readers take where nothing is said.
void describe(const ExrPixels& pixels, Imf::Header& header)
{
    header.insert("software", Imf::StringAttribute("Fumage " FUMAGE_VERSION));
    if (!pixels.isLight) {
        header.insert("comments", Imf::StringAttribute("linear data, not colours"));
    } else if (pixels.layers.front().channels.size() > 1) {
        Imf::addChromaticities(header, Imf::Chromaticities());
    }
    if (pixels.notes.frameRate > 0) {
        Imf::addFramesPerSecond(header, Imf::Rational(pixels.notes.frameRate, 1));
    }
    if (!pixels.notes.preset.empty()) {
        header.insert(kPresetNote.data(), Imf::StringAttribute(pixels.notes.preset));
        header.insert(kFrameNote.data(), Imf::IntAttribute(pixels.notes.frame));
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
    for (const ExrLayer& layer : pixels.layers) {
        samples.emplace_back(layer.values.begin(), layer.values.end());
        const std::size_t pixelStride = sizeof(Sample) * layer.channels.size();
        for (std::size_t i = 0; i < layer.channels.size(); ++i) {
            const std::string name = (layer.name.empty() ? "" : layer.name + ".") + layer.channels[i];
            header.channels().insert(name, Imf::Channel(type));
            buffer.insert(name, Imf::Slice(type, reinterpret_cast<char*>(samples.back().data() + i), pixelStride, pixelStride * static_cast<std::size_t>(pixels.width)));
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
            return Error{ErrorCode::Syntax, said("a channel of the picture has fewer numbers than there are pixels"), {}, {}};
        }
        ++count;
    }
    const auto most = static_cast<std::int64_t>(kMostReadPixels);
    if (width < 1 || height < 1 || width > most || height > most || width * height > most || width * height * count > static_cast<std::int64_t>(kMostReadNumbers)) {
        return Error{ErrorCode::TooLarge, said("a picture of %1 x %2 pixels", width, height), {}, {}};
    }
    return Done{};
}

Result<ExrNumbers> numbersOf(Imf::InputFile& file)
{
    const Imath::Box2i window = file.header().dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    const Imf::ChannelList& channels = file.header().channels();
    if (Status status = checkShape(width, height, channels); !status) {
        return status.error();
    }
    ExrNumbers numbers{static_cast<int>(width), static_cast<int>(height), {}};
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        numbers.channels.push_back({channel.name(), std::vector<float>(static_cast<std::size_t>(width * height))});
    }
    Imf::FrameBuffer buffer;
    for (ExrNumbers::Channel& channel : numbers.channels) {
        const std::size_t rowStride = sizeof(float) * static_cast<std::size_t>(width);
        buffer.insert(channel.name, Imf::Slice::Make(Imf::FLOAT, channel.values.data(), window, sizeof(float), rowStride));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return numbers;
}

/// A callback of OpenEXR's C library, which has no limits but those of what it reads from.
std::int64_t readHead(exr_const_context_t /*context*/, void* user, void* to, std::uint64_t size, std::uint64_t at, exr_stream_error_func_ptr_t /*error*/)
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

PictureNotes notesOf(exr_const_context_t file)
{
    PictureNotes notes;
    const char* text = nullptr;
    std::int32_t length = 0;
    if (exr_attr_get_string(file, 0, kPresetNote.data(), &length, &text) == EXR_ERR_SUCCESS && length > 0 && static_cast<std::size_t>(length) <= kMostNoteBytes) {
        notes.preset.assign(text, static_cast<std::size_t>(length));
    }
    std::int32_t frame = 0;
    if (exr_attr_get_int(file, 0, kFrameNote.data(), &frame) == EXR_ERR_SUCCESS) {
        notes.frame = frame;
    }
    return notes;
}

} // namespace

std::string exrChannels(int count)
{
    return count == 1 ? "Y" : count == 3 ? "RGB"
                                         : "RGBA";
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
            return Error{ErrorCode::Cancelled, said("the picture was cancelled"), {}, {}};
        }
        return stream.take();
    } catch (const std::exception& cause) {
        return Error{ErrorCode::WriteFailed, said("the picture cannot be written as EXR: %1", cause.what()), {}, {}};
    }
}

Result<PictureNotes> readExrNotes(std::string_view head)
{
    exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
    start.error_handler_fn = ignore;
    start.user_data = &head;
    start.read_fn = readHead;
    start.size_fn = sizeOfHead;
    exr_context_t file = nullptr;
    const exr_result_t opened = exr_start_read(&file, "memory", &start);
    if (opened != EXR_ERR_SUCCESS) {
        return Error{ErrorCode::Syntax, said("the picture is broken: %1", exr_get_default_error_message(opened)), {}, {}};
    }
    const PictureNotes notes = notesOf(file);
    exr_finish(&file);
    return notes;
}

Result<ExrNumbers> readExr(std::span<const std::byte> file)
{
    try {
        MemorySource source(file);
        Imf::InputFile input(source, 0);
        return numbersOf(input);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, said("there is not enough memory"), {}, {}};
    } catch (const std::exception& cause) {
        return Error{ErrorCode::Syntax, said("the picture is broken: %1", cause.what()), {}, {}};
    }
}

} // namespace fumage
