#include "core/export/png_file.h"

#include <bit>
#include <string>

#include <png.h>

namespace fumage {

namespace {

/// What libpng's callbacks write to.
struct Sink {
    std::vector<std::byte> bytes;
    std::string message;
};

void append(png_structp png, png_bytep data, png_size_t size)
{
    auto* sink = static_cast<Sink*>(png_get_io_ptr(png));
    const auto* from = reinterpret_cast<const std::byte*>(data);
    sink->bytes.insert(sink->bytes.end(), from, from + size);
}

void flush(png_structp /*png*/) { }

void fail(png_structp png, png_const_charp message)
{
    static_cast<Sink*>(png_get_error_ptr(png))->message = message;
    png_longjmp(png, 1);
}

void ignore(png_structp /*png*/, png_const_charp /*message*/) { }

void setText(png_structp png, png_infop info, const char* key, const char* value)
{
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    // The library takes pointers to non-const and does not write through them.
    text.key = const_cast<char*>(key); // NOLINT(cppcoreguidelines-pro-type-const-cast)
    text.text = const_cast<char*>(value); // NOLINT(cppcoreguidelines-pro-type-const-cast)
    png_set_text(png, info, &text, 1);
}

/// Between setjmp and longjmp no object may be made that needs its destructor: all of them live in the caller.
bool writePng(png_structp png, png_infop info, const PngPixels& pixels, const std::stop_token& stop)
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
    setText(png, info, "Software", "Fumage");
    if (!pixels.srgb) {
        setText(png, info, "Comment", "Linear data, not sRGB");
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

} // namespace

Result<std::vector<std::byte>> encodePng(const PngPixels& pixels, const std::stop_token& stop)
{
    Sink sink;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, fail, ignore);
    png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
    if (info == nullptr) {
        png_destroy_write_struct(&png, nullptr);
        return Error{ErrorCode::WriteFailed, said("the PNG library could not be started"), {}, {}};
    }
    png_set_write_fn(png, &sink, append, flush);
    const bool written = writePng(png, info, pixels, stop);
    png_destroy_write_struct(&png, &info);
    if (stop.stop_requested()) {
        return Error{ErrorCode::Cancelled, said("the picture was cancelled"), {}, {}};
    }
    if (!written) {
        return Error{ErrorCode::WriteFailed, said("the picture cannot be written as PNG: %1", sink.message), {}, {}};
    }
    return std::move(sink.bytes);
}

} // namespace fumage
