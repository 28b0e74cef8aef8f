#pragma once

#include "core/base/result.h"
#include "core/export/pass_picture.h"
#include "core/scene/scene.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// What stands in one channel of a packed picture.
struct PackedChannel {
    std::optional<Pass> pass; ///< none: the constant
    int channel = 0; ///< of the pass's picture
    float constant = 0.0F; ///< 0 or 1

    friend bool operator==(const PackedChannel&, const PackedChannel&) = default;
};

/// A picture of a flipbook whose channels somebody has chosen out of all passes.
struct PackedPicture {
    std::string name; ///< letters, digits, - and _: "masks" makes boom_masks.png
    std::vector<PackedChannel> channels; ///< 1: grey; 2: red and green; 3: without alpha; 4
    int divisor = 1; ///< its edges are so many times shorter than the other pictures'

    friend bool operator==(const PackedPicture&, const PackedPicture&) = default;
};

/// Most packed pictures of one flipbook, and the most by which one is smaller.
inline constexpr std::size_t kMaxPackedPictures = 5;
inline constexpr int kMaxDivisor = 16;

/// Reads "masks=shadow,temperature,alpha" or "light=six-way-a.r,six-way-a.g,0,alpha@1/2": a pass of one number by its
/// name, others with .r, .g, .b or .a; 0 and 1 are constants. sixway_a and color are understood.
/// @error Syntax, OutOfRange; UnknownName with the nearest channel
[[nodiscard]] Result<PackedPicture> parsePack(std::string_view text);

/// "shadow", "six-way-a.r", "0": what parsePack() reads.
[[nodiscard]] std::string textOf(const PackedChannel& channel);

/// "masks=shadow,temperature,alpha@1/2": what parsePack() reads.
[[nodiscard]] std::string textOf(const PackedPicture& pack);

/// All that there are, the constants first.
[[nodiscard]] std::vector<PackedChannel> allChannels();

/// The passes that packed pictures are made of.
[[nodiscard]] PassSet passesOf(std::span<const PackedPicture> packs);

/// Whether a flipbook can have such pictures beside those of its passes.
/// @error OutOfRange: too many of them, names that cannot be those of files, two of one name, no channels, or cells
/// that cannot be made so much smaller
[[nodiscard]] Status checkPacks(std::span<const PackedPicture> packs, int cellWidth, int cellHeight);

/// Whether the colours of a picture are sRGB, since they are those of the colour's picture and nothing else; its
/// numbers are linear otherwise.
[[nodiscard]] bool isSrgb(const PackedPicture& pack, ImageFormat format);

/// Makes packed pictures of a sheet. Smaller ones hold averages of blocks, weighted by alpha where numbers are not
/// multiplied by it.
class Packer {
public:
    /// @param sheet,pictures of all passes of the pictures; must stay, as must the scene
    Packer(const PassSheet& sheet, const PassPictures& pictures, const PassStyle& style, const Scene& scene,
        ImageFormat format)
        : m_sheet(sheet)
        , m_pictures(pictures)
        , m_style(style)
        , m_scene(scene)
        , m_format(format)
    {
    }

    /// The numbers of one; in formats without floats vectors and normals are (1 + value) / 2 already.
    /// O(pixels).
    [[nodiscard]] DataImage pack(const PackedPicture& pack) const;

private:
    [[nodiscard]] DataImage source(Pass pass, int divisor) const;
    [[nodiscard]] DataImage colour(int divisor) const;
    [[nodiscard]] DataImage averaged(const DataImage& image, Pass pass, int divisor) const;

    const PassSheet& m_sheet;
    const PassPictures& m_pictures;
    PassStyle m_style;
    const Scene& m_scene;
    ImageFormat m_format;
};

} // namespace fumage
