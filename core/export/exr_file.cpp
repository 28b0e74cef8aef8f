#include "core/export/exr_file.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <string>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

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

/// Says what the numbers mean: linear light in the primaries of Rec. 709 and sRGB, which are those that readers take where nothing is said.
void describe(const ExrPixels& pixels, Imf::Header& header)
{
    header.insert("software", Imf::StringAttribute("Fumage"));
    if (!pixels.isLight) {
        header.insert("comments", Imf::StringAttribute("linear data, not colours"));
    } else if (pixels.layers.front().channels.size() > 1) {
        Imf::addChromaticities(header, Imf::Chromaticities());
    }
    if (pixels.frameRate > 0) {
        Imf::addFramesPerSecond(header, Imf::Rational(pixels.frameRate, 1));
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

} // namespace fumage
