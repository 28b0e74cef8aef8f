#include "core/picture_files/png_file.h"

#include "core/base/text.h"
#include "core/version.h"

#include <bit>
#include <cstdlib>
#include <cstring>
#include <limits>
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

/// What they read from.
struct Source {
    std::string_view head;
    std::size_t at = 0;
};

void take(png_structp png, png_bytep data, png_size_t size)
{
    auto* source = static_cast<Source*>(png_get_io_ptr(png));
    if (size > source->head.size() - source->at) {
        png_error(png, "it ends too soon");
    }
    std::memcpy(data, source->head.data() + source->at, size);
    source->at += size;
}

/// @param png with the text for the message as its pointer for errors
void fail(png_structp png, png_const_charp message)
{
    *static_cast<std::string*>(png_get_error_ptr(png)) = message;
    png_longjmp(png, 1);
}

void ignore(png_structp /*png*/, png_const_charp /*message*/) { }

/// Memory for what is read. The library's own limit of a chunk is but a warning in its version 1.6: a chunk may say that it has 2 GiB.
png_voidp allocate(png_structp /*png*/, png_alloc_size_t size)
{
    return size <= kPictureHead ? std::malloc(size) : nullptr; // NOLINT(cppcoreguidelines-no-malloc)
}

void release(png_structp /*png*/, png_voidp memory)
{
    std::free(memory); // NOLINT(cppcoreguidelines-no-malloc)
}

/// @param compression PNG_TEXT_COMPRESSION_NONE: Latin-1 as it stands; PNG_ITXT_COMPRESSION_zTXt: UTF-8, packed
void setText(png_structp png, png_infop info, const char* key, const char* value, int compression = PNG_TEXT_COMPRESSION_NONE)
{
    png_text text{};
    text.compression = compression;
    // The library takes pointers to non-const and does not write through them.
    text.key = const_cast<char*>(key); // NOLINT(cppcoreguidelines-pro-type-const-cast)
    text.text = const_cast<char*>(value); // NOLINT(cppcoreguidelines-pro-type-const-cast)
    png_set_text(png, info, &text, 1);
}

// Between setjmp and longjmp no object may be made that needs its destructor: all of them live in the caller.

/// @param frame that the notes name
bool writePng(png_structp png, png_infop info, const PngPixels& pixels, const char* frame, const std::stop_token& stop)
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
    png_set_IHDR(png, info, static_cast<png_uint_32>(pixels.width), static_cast<png_uint_32>(pixels.height), pixels.bits,
        pixels.channels == 1 ? PNG_COLOR_TYPE_GRAY : pixels.channels == 3 ? PNG_COLOR_TYPE_RGB
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
    if (!pixels.notes.preset.empty()) {
        setText(png, info, kPresetNote.data(), pixels.notes.preset.c_str(), PNG_ITXT_COMPRESSION_zTXt);
        setText(png, info, kFrameNote.data(), frame);
    }
    png_write_info(png, info);
    if (pixels.bits == 16 && std::endian::native == std::endian::little) {
        png_set_swap(png);
    }
    const std::size_t stride = static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.channels) * static_cast<std::size_t>(pixels.bits / 8);
    for (int y = 0; y < pixels.height; ++y) {
        if (stop.stop_requested()) {
            return false;
        }
        png_write_row(png, reinterpret_cast<png_const_bytep>(pixels.bytes.data() + static_cast<std::size_t>(y) * stride));
    }
    png_write_end(png, info);
    return true;
}

/// Reads all that stands before the pixels. A text that is damaged, or larger than a note may be, is left out by the library.
bool readHead(png_structp png, png_infop info)
{
    if (setjmp(png_jmpbuf(png)) != 0) { // NOLINT(cert-err52-cpp)
        return false;
    }
    constexpr png_uint_32 kMostChunks = 64;
    constexpr png_uint_32 kAnyEdge = std::numeric_limits<png_int_32>::max();
    png_set_user_limits(png, kAnyEdge, kAnyEdge); // no row is ever made
    png_set_chunk_cache_max(png, kMostChunks);
    png_set_chunk_malloc_max(png, kMostNoteBytes);
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
    png_set_chunk_malloc_max(png, kMostNoteBytes);
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

/// Reads all rows, and on to the end of the file.
bool readRows(png_structp png, png_infop info, RgbaPixels& pixels)
{
    if (setjmp(png_jmpbuf(png)) != 0) { // NOLINT(cert-err52-cpp)
        return false;
    }
    const int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    const std::size_t stride = static_cast<std::size_t>(pixels.width) * 4;
    for (int pass = 0; pass < passes; ++pass) {
        for (int y = 0; y < pixels.height; ++y) {
            png_read_row(png, reinterpret_cast<png_bytep>(pixels.values.data() + static_cast<std::size_t>(y) * stride), nullptr);
        }
    }
    png_read_end(png, nullptr);
    return true;
}

/// The notes among the texts of a picture.
PictureNotes notesAmong(png_structp png, png_infop info)
{
    PictureNotes notes;
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(png, info, &texts, &count);
    for (int i = 0; i < count; ++i) {
        const png_text& text = texts[i]; // NOLINT(cppcoreguidelines-pro-bounds-pointer-arithmetic)
        if (text.key == kPresetNote) {
            notes.preset = text.text;
        } else if (text.key == kFrameNote) {
            notes.frame = static_cast<int>(parseInteger(text.text).value_or(0));
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
        return info == nullptr ? Error{ErrorCode::ReadFailed, said("the PNG library could not be started"), {}, {}} : Error{ErrorCode::Syntax, said("the picture is broken: %1", m_message), {}, {}};
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
    const std::string frame = std::to_string(pixels.notes.frame);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, fail, ignore);
    png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
    if (info == nullptr) {
        png_destroy_write_struct(&png, nullptr);
        return Error{ErrorCode::WriteFailed, said("the PNG library could not be started"), {}, {}};
    }
    png_set_write_fn(png, &sink, append, flush);
    const bool written = writePng(png, info, pixels, frame.c_str(), stop);
    png_destroy_write_struct(&png, &info);
    if (stop.stop_requested()) {
        return Error{ErrorCode::Cancelled, said("the picture was cancelled"), {}, {}};
    }
    if (!written) {
        return Error{ErrorCode::WriteFailed, said("the picture cannot be written as PNG: %1", message), {}, {}};
    }
    return std::move(sink.bytes);
}

Result<PictureNotes> readPngNotes(std::string_view head)
{
    Source source{head};
    Reader reader(source);
    if (!reader) {
        return reader.error();
    }
    const bool read = readHead(reader.png, reader.info);
    const PictureNotes notes = notesAmong(reader.png, reader.info);
    return read ? Result<PictureNotes>(notes) : reader.error();
}

Result<RgbaPixels> readPng(std::span<const std::byte> file)
{
    Source source{{reinterpret_cast<const char*>(file.data()), file.size()}};
    Reader reader(source);
    RgbaPixels pixels;
    if (!reader || !readShape(reader.png, reader.info, pixels)) {
        return reader.error();
    }
    const std::size_t count = static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height);
    if (count > kMostReadPixels) {
        return Error{ErrorCode::TooLarge, said("a picture of %1 x %2 pixels", pixels.width, pixels.height), {}, {}};
    }
    pixels.values.resize(count * 4);
    if (!readRows(reader.png, reader.info, pixels)) {
        return reader.error();
    }
    return pixels;
}

} // namespace fumage
