#include "core/image_io/png_chunks.h"

namespace fumage {

namespace {

/// A file with more chunks is not looked at to its end: pixels come in some of 8 KiB or more.
constexpr int kMaxPngChunks = 1 << 20;
constexpr std::size_t kHeaderBytes = 8; ///< length and kind, which stand before a chunk
constexpr std::size_t kSumBytes = 4; ///< of the checksum behind it
/// Where pixels begin: a chunk of none of them, with its checksum.
constexpr std::string_view kNoPixels("\0\0\0\0IDAT\x35\xAF\x06\x1E", 12);

struct Chunk {
    std::uint64_t at = 0; ///< of its header
    std::uint64_t length = 0;
    std::string kind;
    std::string beginning; ///< of what it holds

    [[nodiscard]] std::uint64_t end() const { return at + kHeaderBytes + length + kSumBytes; }
    [[nodiscard]] bool isText() const { return kind == "tEXt" || kind == "zTXt" || kind == "iTXt"; }
    /// Whether it is a text with this key, which ends with a zero byte.
    [[nodiscard]] bool isNote(std::string_view key) const
    {
        return isText() && beginning.starts_with(key) && beginning.size() > key.size() && beginning[key.size()] == '\0';
    }
    [[nodiscard]] bool isOurs() const { return isNote(kPresetNote) || isNote(kFrameNote) || isNote(kSheetNote); }
};

/// The chunk at a place; of no kind where the file ends.
Result<Chunk> chunkAt(const PartReader& file, std::uint64_t at)
{
    constexpr std::size_t kKeyBytes = 16; // longer than our keys
    const Result<std::string> part = file(at, kHeaderBytes + kKeyBytes);
    if (!part) {
        return part.error();
    }
    Chunk chunk;
    if (part.value().size() >= kHeaderBytes) {
        chunk.at = at;
        for (std::size_t i = 0; i < 4; ++i) {
            chunk.length = (chunk.length << 8U) + static_cast<unsigned char>(part.value()[i]);
        }
        chunk.kind = part.value().substr(4, 4);
        chunk.beginning = part.value().substr(kHeaderBytes, chunk.length);
    }
    return chunk;
}

/// Adds a chunk as it is, where it is not larger than a note may be.
Status add(const PartReader& file, const Chunk& chunk, PngTexts& texts)
{
    constexpr std::size_t kSpare = 1024; // of the key, and of what is larger packed
    texts.hasPreset = texts.hasPreset || chunk.isNote(kPresetNote);
    if (chunk.length > kMaxNoteBytes + kSpare || texts.file.size() + chunk.length > kPictureHead) {
        return Done{};
    }
    const Result<std::string> whole = file(chunk.at, static_cast<std::size_t>(chunk.end() - chunk.at));
    if (!whole) {
        return whole.error();
    }
    texts.file += whole.value();
    return Done{};
}

} // namespace

Result<PngTexts> textsOfPng(const PartReader& file)
{
    PngTexts texts{std::string(kPngSignature), false};
    bool seenPixels = false;
    std::uint64_t at = kPngSignature.size();
    for (int count = 0; count < kMaxPngChunks; ++count) {
        const Result<Chunk> chunk = chunkAt(file, at);
        if (!chunk) {
            return chunk.error();
        }
        if (chunk.value().kind.empty() || chunk.value().kind == "IEND") {
            break;
        }
        if (chunk.value().kind == "IDAT") {
            seenPixels = true;
            if (texts.hasPreset) {
                break;
            }
        }
        // The size and the palette are what the library wants to see before the pixels.
        const bool isWanted = count == 0 || chunk.value().kind == "PLTE" || chunk.value().isOurs();
        if (Status status = isWanted ? add(file, chunk.value(), texts) : Status(Done{}); !status) {
            return status.error();
        }
        at = chunk.value().end();
    }
    if (!seenPixels) {
        return Error{ErrorCode::Syntax, makeMessage("the picture is broken: %1", "it ends too soon"), {}, {}};
    }
    texts.file += kNoPixels;
    return texts;
}

std::vector<std::byte> withoutNotes(std::span<const std::byte> png)
{
    const std::string_view bytes(reinterpret_cast<const char*>(png.data()), png.size());
    const PartReader file = partsOf(bytes);
    std::uint64_t at = bytes.starts_with(kPngSignature) ? kPngSignature.size() : png.size();
    std::vector<std::byte> out(png.begin(), png.begin() + static_cast<std::ptrdiff_t>(at));
    while (at < png.size()) {
        const Result<Chunk> chunk = chunkAt(file, at);
        const bool isWhole = chunk && !chunk.value().kind.empty() && chunk.value().end() <= png.size();
        const std::uint64_t end = isWhole ? chunk.value().end() : png.size();
        if (!isWhole || !chunk.value().isOurs()) {
            const std::span<const std::byte> kept =
                png.subspan(static_cast<std::size_t>(at), static_cast<std::size_t>(end - at));
            out.insert(out.end(), kept.begin(), kept.end());
        }
        at = end;
    }
    return out;
}

} // namespace fumage
