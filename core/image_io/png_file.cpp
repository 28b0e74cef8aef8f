#include "core/image_io/png_file.h"

#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/version.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <optional>
#include <string>

#include <png.h>

namespace fumage {

namespace {

constexpr const char* kSoftware = "Fumage " FUMAGE_VERSION;

/// What libpng's callbacks write to.
struct Sink {
    std::vector<std::byte> bytes;
};

void append(png_structp png, png_bytep data, png_size_t size)
{
    auto* sink = static_cast<Sink*>(png_get_io_ptr(png));
    const auto* from = reinterpret_cast<const std::byte*>(data);
    sink->bytes.insert(sink->bytes.end(), from, from + size);
}

void flush(png_structp /*png*/) { }

/// What they read from, a part at a time.
class Source {
public:
    explicit Source(const PartReader& file)
        : m_file(file)
    {
    }

    /// @return whether there was so much
    bool take(png_bytep to, std::size_t size)
    {
        while (size > 0) {
            if (m_used == m_part.size() && !fetch()) {
                return false;
            }
            const std::size_t count = std::min(size, m_part.size() - m_used);
            std::memcpy(to, m_part.data() + m_used, count);
            m_used += count;
            to += count; // NOLINT(cppcoreguidelines-pro-bounds-pointer-arithmetic)
            size -= count;
        }
        return true;
    }

    /// Why the file could not be read, where it is not the picture that is to blame.
    [[nodiscard]] const std::optional<Error>& failure() const { return m_failure; }

private:
    bool fetch()
    {
        constexpr std::size_t kPart = std::size_t{1} << 16U;
        // no exception may cross the library
        Result<std::string> part = withinMemory([&] { return m_file(m_at, kPart); });
        if (!part) {
            m_failure = part.error();
            return false;
        }
        m_part = std::move(part).value();
        m_at += m_part.size();
        m_used = 0;
        return !m_part.empty();
    }

    const PartReader& m_file;
    std::string m_part;
    std::size_t m_used = 0; ///< of the part
    std::uint64_t m_at = 0; ///< of the part's end
    std::optional<Error> m_failure;
};

void take(png_structp png, png_bytep data, png_size_t size)
{
    if (!static_cast<Source*>(png_get_io_ptr(png))->take(data, size)) {
        png_error(png, "it ends too soon");
    }
}

/// @param png with the text for the message as its pointer for errors
void fail(png_structp png, png_const_charp message)
{
    *static_cast<std::string*>(png_get_error_ptr(png)) = message;
    png_longjmp(png, 1);
}

void ignore(png_structp /*png*/, png_const_charp /*message*/) { }

/// Memory for what is read. The library's own limit of a chunk is but a warning in its version 1.6: a chunk may say
/// that it has 2 GiB.
png_voidp allocate(png_structp /*png*/, png_alloc_size_t size)
{
    return size <= kPictureHead ? std::malloc(size) : nullptr; // NOLINT(cppcoreguidelines-no-malloc)
}

void release(png_structp /*png*/, png_voidp memory)
{
    std::free(memory); // NOLINT(cppcoreguidelines-no-malloc)
}

/// Latin-1; not as UTF-8, which ImageMagick drops.
/// @param compression PNG_TEXT_COMPRESSION_NONE: as it stands; PNG_TEXT_COMPRESSION_zTXt: packed
void setText(
    png_structp png, png_infop info, const char* key, const char* value, int compression = PNG_TEXT_COMPRESSION_NONE)
{
    png_text text{};
    text.compression = compression;
    // The library takes pointers to non-const and does not write through them.
    text.key = const_cast<char*>(key); // NOLINT(cppcoreguidelines-pro-type-const-cast)
    text.text = const_cast<char*>(value); // NOLINT(cppcoreguidelines-pro-type-const-cast)
    png_set_text(png, info, &text, 1);
}

// Between setjmp and longjmp no object may be made that needs its destructor: all of them live in the caller.

/// Notes as texts of ASCII.
struct WrittenNotes {
    std::string preset;
    std::string frame;
    std::string sheet;
};

bool writePng(
    png_structp png, png_infop info, const PngPixels& pixels, const WrittenNotes& notes, const std::stop_token& stop)
{
    if (setjmp(png_jmpbuf(png)) != 0) { // NOLINT(cert-err52-cpp): libpng's way to report errors
        return false;
    }
    // Fast enough for animation, and within a few per cent of the smallest file for soft pictures.
    constexpr int kCompression = 4;
    constexpr int kQuickCompression = 2;
    png_set_compression_level(png, pixels.quick ? kQuickCompression : kCompression);
    if (pixels.quick) {
        png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    }
    png_set_IHDR(png, info, static_cast<png_uint_32>(pixels.width), static_cast<png_uint_32>(pixels.height),
        pixels.bits,
        pixels.channels == 1       ? PNG_COLOR_TYPE_GRAY
            : pixels.channels == 3 ? PNG_COLOR_TYPE_RGB
                                   : PNG_COLOR_TYPE_RGB_ALPHA,
        PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (pixels.srgb) {
        png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    }
    // Data says so in words: engines that see a gamma of 1 bend the numbers back to sRGB when they read them.
    setText(png, info, "Software", kSoftware);
    if (!pixels.srgb) {
        setText(png, info, "Comment", "Linear data, not sRGB");
    }
    if (!notes.preset.empty()) {
        setText(png, info, kPresetNote.data(), notes.preset.c_str(), PNG_TEXT_COMPRESSION_zTXt);
        setText(png, info, kFrameNote.data(), notes.frame.c_str());
    }
    if (!notes.preset.empty() && !notes.sheet.empty()) {
        setText(png, info, kSheetNote.data(), notes.sheet.c_str());
    }
    png_write_info(png, info);
    if (pixels.bits == 16 && std::endian::native == std::endian::little) {
        png_set_swap(png);
    }
    const std::size_t stride = static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.channels)
        * static_cast<std::size_t>(pixels.bits / 8);
    for (int y = 0; y < pixels.height; ++y) {
        if (stop.stop_requested()) {
            return false;
        }
        png_write_row(
            png, reinterpret_cast<png_const_bytep>(pixels.bytes.data() + static_cast<std::size_t>(y) * stride));
    }
    png_write_end(png, info);
    return true;
}

/// Reads the texts. One that is damaged, or larger than a note may be, is left out by the library.
bool readHead(png_structp png, png_infop info)
{
    if (setjmp(png_jmpbuf(png)) != 0) { // NOLINT(cert-err52-cpp)
        return false;
    }
    constexpr png_uint_32 kMaxChunks = 64;
    constexpr png_uint_32 kAnyEdge = std::numeric_limits<png_int_32>::max();
    png_set_user_limits(png, kAnyEdge, kAnyEdge); // no row is ever made
    png_set_chunk_cache_max(png, kMaxChunks);
    png_set_chunk_malloc_max(png, kMaxNoteBytes);
    png_read_info(png, info);
    return true;
}

/// Sets the size, and has the library hand out RGBA of 16 bits in the byte order of this machine.
bool readShape(png_structp png, png_infop info, RgbaPixels& pixels)
{
    if (setjmp(png_jmpbuf(png)) != 0) { // NOLINT(cert-err52-cpp)
        return false;
    }
    constexpr png_uint_32 kOpaque = 0xffff;
    png_set_chunk_malloc_max(png, kMaxNoteBytes);
    png_read_info(png, info);
    pixels.width = static_cast<int>(png_get_image_width(png, info));
    pixels.height = static_cast<int>(png_get_image_height(png, info));
    png_set_expand_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, kOpaque, PNG_FILLER_AFTER);
    if (std::endian::native == std::endian::little) {
        png_set_swap(png);
    }
    return true;
}

using RowSink = std::function<void(std::span<const std::uint16_t> row)>;

/// Reads all rows, and on to the end of the file.
/// @param pixels with as many values as are kept: all of them where the picture is interlaced, else one row
bool readRows(png_structp png, png_infop info, RgbaPixels& pixels, const RowSink& row)
{
    if (setjmp(png_jmpbuf(png)) != 0) { // NOLINT(cert-err52-cpp)
        return false;
    }
    const int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    const std::size_t stride = static_cast<std::size_t>(pixels.width) * 4;
    const auto at = [&](int y) {
        return pixels.values.data() + (passes > 1 ? static_cast<std::size_t>(y) * stride : 0);
    };
    for (int pass = 0; pass < passes; ++pass) {
        for (int y = 0; y < pixels.height; ++y) {
            png_read_row(png, reinterpret_cast<png_bytep>(at(y)), nullptr);
            if (pass + 1 == passes) {
                row({at(y), stride});
            }
        }
    }
    png_read_end(png, nullptr);
    return true;
}

/// The notes among the texts of a picture.
ImageMetadata notesAmong(png_structp png, png_infop info)
{
    ImageMetadata notes;
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(png, info, &texts, &count);
    for (int i = 0; i < count; ++i) {
        const png_text& text = texts[i]; // NOLINT(cppcoreguidelines-pro-bounds-pointer-arithmetic)
        if (text.key == kPresetNote) {
            notes.preset = text.text;
        } else if (text.key == kFrameNote) {
            notes.frame = static_cast<int>(parseInteger(text.text).value_or(0));
        } else if (text.key == kSheetNote) {
            notes.sheet = text.text;
        }
    }
    return notes;
}

/// The library, reading.
class Reader {
public:
    explicit Reader(Source& source)
        : png(png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &m_message, fail, ignore, nullptr, allocate, release))
        , info(png == nullptr ? nullptr : png_create_info_struct(png))
    {
        if (info != nullptr) {
            png_set_read_fn(png, &source, take);
        }
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    explicit operator bool() const { return info != nullptr; }
    [[nodiscard]] Error error() const
    {
        return info == nullptr
            ? Error{ErrorCode::ReadFailed, makeMessage("the PNG library could not be started"), {}, {}}
            : Error{ErrorCode::Syntax, makeMessage("the picture is broken: %1", m_message), {}, {}};
    }

private:
    std::string m_message; // made before the library, which writes to it

public:
    png_structp png;
    png_infop info;
};

} // namespace

Result<std::vector<std::byte>> encodePng(const PngPixels& pixels, const std::stop_token& stop)
{
    Sink sink;
    std::string message;
    const WrittenNotes notes{
        asciiJson(pixels.notes.preset), std::to_string(pixels.notes.frame), asciiJson(pixels.notes.sheet)};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, fail, ignore);
    png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
    if (info == nullptr) {
        png_destroy_write_struct(&png, nullptr);
        return Error{ErrorCode::WriteFailed, makeMessage("the PNG library could not be started"), {}, {}};
    }
    png_set_write_fn(png, &sink, append, flush);
    const bool written = writePng(png, info, pixels, notes, stop);
    png_destroy_write_struct(&png, &info);
    if (stop.stop_requested()) {
        return Error{ErrorCode::Cancelled, makeMessage("the picture was cancelled"), {}, {}};
    }
    if (!written) {
        return Error{ErrorCode::WriteFailed, makeMessage("the picture cannot be written as PNG: %1", message), {}, {}};
    }
    return std::move(sink.bytes);
}

Result<ImageMetadata> readPngNotes(const PngTexts& texts)
{
    const PartReader file = partsOf(texts.file);
    Source source(file);
    Reader reader(source);
    if (!reader) {
        return reader.error();
    }
    const bool read = readHead(reader.png, reader.info);
    const ImageMetadata notes = notesAmong(reader.png, reader.info);
    if (!read) {
        return reader.error();
    }
    const bool isTooLong = notes.preset.size() > kMaxNoteBytes || notes.sheet.size() > kMaxNoteBytes;
    return isTooLong || (texts.hasPreset && notes.preset.empty()) ? damagedNote() : Result<ImageMetadata>(notes);
}

Status readPngRows(const PartReader& file, const std::function<void(int width, int height)>& begin, const RowSink& row)
{
    Source source(file);
    Reader reader(source);
    const auto error = [&] { return source.failure() ? *source.failure() : reader.error(); };
    RgbaPixels pixels;
    if (!reader || !readShape(reader.png, reader.info, pixels)) {
        return error();
    }
    const std::size_t count = static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height);
    if (count > kMaxReadPixels) {
        return Error{
            ErrorCode::TooLarge, makeMessage("a picture of %1 x %2 pixels", pixels.width, pixels.height), {}, {}};
    }
    begin(pixels.width, pixels.height);
    const bool isInterlaced = png_get_interlace_type(reader.png, reader.info) != PNG_INTERLACE_NONE;
    pixels.values.resize(4 * (isInterlaced ? count : static_cast<std::size_t>(pixels.width)));
    return readRows(reader.png, reader.info, pixels, row) ? Status(Done{}) : error();
}

Result<RgbaPixels> readPng(std::span<const std::byte> file)
{
    RgbaPixels pixels;
    const auto begin = [&](int width, int height) {
        pixels.width = width;
        pixels.height = height;
        pixels.values.reserve(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    };
    const auto keep = [&](std::span<const std::uint16_t> row) {
        pixels.values.insert(pixels.values.end(), row.begin(), row.end());
    };
    const Status status = readPngRows(partsOf({reinterpret_cast<const char*>(file.data()), file.size()}), begin, keep);
    return status ? Result<RgbaPixels>(std::move(pixels)) : status.error();
}

} // namespace fumage
