#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include <QtTest/QtTest>
#include <png.h>

namespace fumage::tests {

/// A PNG as libpng's own reader has it, without any conversion but the byte order of 16 bits.
struct PngFile {
    int width = 0;
    int height = 0;
    int channels = 0;
    int bits = 0; ///< a sample: 8 or 16
    int colourType = -1; ///< PNG_COLOR_TYPE_...
    bool hasSrgb = false;
    bool hasGamma = false;
    std::vector<std::uint16_t> samples; ///< row by row from the top, a pixel's channels side by side

    /// Ends the test where the file cannot be read.
    explicit PngFile(const std::string& path)
    {
        std::FILE* file = std::fopen(path.c_str(), "rb");
        if (file == nullptr) {
            qFatal("%s", path.c_str());
        }
        read([&](png_structp png) { png_init_io(png, file); });
        std::fclose(file);
    }
    explicit PngFile(std::span<const std::byte> bytes)
    {
        read([&](png_structp png) {
            png_set_read_fn(png, &bytes, [](png_structp reader, png_bytep to, png_size_t size) {
                auto& rest = *static_cast<std::span<const std::byte>*>(png_get_io_ptr(reader));
                if (size > rest.size()) {
                    png_error(reader, "the file ends too early");
                }
                std::memcpy(to, rest.data(), size);
                rest = rest.subspan(size);
            });
        });
    }
    [[nodiscard]] int at(int x, int y, int channel = 0) const
    {
        return samples[static_cast<std::size_t>((y * width + x) * channels + channel)];
    }

private:
    template <class SetSource>
    void read(const SetSource& setSource)
    {
        png_structp png = png_create_read_struct(
            PNG_LIBPNG_VER_STRING, nullptr, [](png_structp, png_const_charp why) { qFatal("%s", why); }, nullptr);
        png_infop info = png_create_info_struct(png);
        setSource(png);
        png_read_png(png, info, PNG_TRANSFORM_SWAP_ENDIAN, nullptr);
        width = static_cast<int>(png_get_image_width(png, info));
        height = static_cast<int>(png_get_image_height(png, info));
        channels = png_get_channels(png, info);
        bits = png_get_bit_depth(png, info);
        colourType = png_get_color_type(png, info);
        int intent = 0;
        hasSrgb = png_get_sRGB(png, info, &intent) != 0;
        double gamma = 0.0;
        hasGamma = png_get_gAMA(png, info, &gamma) != 0;
        for (int y = 0; y < height; ++y) {
            const png_bytep row = png_get_rows(png, info)[y];
            for (int i = 0; i < width * channels; ++i) {
                std::uint16_t sample = row[i];
                if (bits == 16) {
                    std::memcpy(&sample, row + std::ptrdiff_t{2} * i, sizeof(sample));
                }
                samples.push_back(sample);
            }
        }
        png_destroy_read_struct(&png, &info, nullptr);
    }
};

} // namespace fumage::tests
