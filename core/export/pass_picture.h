#pragma once

#include "core/export/glow_ramp.h"
#include "core/export/image_file.h"
#include "core/export/layer_mask.h"
#include "core/export/sheets/motion_refine.h"
#include "core/rendering/passes.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// Which light stands in which channel of the two maps of six-way light.
enum class SixWayLayout {
    Unity, ///< right, top, back, alpha; left, bottom, front, emissive
    EmberGen, ///< top, left, right, alpha; bottom, back, front, alpha
    RltBbf, ///< right, left, top, alpha; bottom, back, front, alpha: O3DE's RtLftTp_BtBckFr
    TlrbFb, ///< top, left, right, bottom; front, back, nothing, alpha: O3DE's TpLftRtBt_FrBck
};
inline constexpr std::size_t kSixWayLayouts = 4;

/// What stands in one channel of a map.
enum class SixWayChannel {
    Right,
    Left,
    Top,
    Bottom,
    Back,
    Front,
    Alpha,
    Emissive,
    Nothing,
};

/// The channels of a layout's maps, A and B, red to alpha.
[[nodiscard]] std::array<std::array<SixWayChannel, 4>, 2> channelsOf(SixWayLayout layout);
/// "right", "top", as the side-car says it.
[[nodiscard]] std::string_view nameOf(SixWayChannel channel);
/// "unity", "embergen", "rlt-bbf", "tlrb-fb".
[[nodiscard]] std::string_view nameOf(SixWayLayout layout);

/// "sixway_a", "motion": what names of files and targets call a pass.
[[nodiscard]] std::string fileNameOf(Pass pass);

/// Signs of motion vectors.
enum class VectorSigns {
    Unity, ///< red is more than a half where the smoke goes right, green where it goes up
    Unreal, ///< red is more than a half where it goes left, green where it goes up
};
inline constexpr std::size_t kVectorSigns = 2;
/// "unity", "unreal".
[[nodiscard]] std::string_view nameOf(VectorSigns signs);

/// Which way green leads in normals.
enum class NormalGreen {
    OpenGl, ///< up: Unity, Godot, Blender
    DirectX, ///< down: Unreal
};
inline constexpr std::size_t kNormalGreens = 2;
/// "opengl", "directx".
[[nodiscard]] std::string_view nameOf(NormalGreen green);

/// How passes are written.
struct PassStyle {
    SixWayLayout layout = SixWayLayout::Unity;
    VectorSigns vectors = VectorSigns::Unity;
    bool premultiplied = false; ///< colours and light times alpha; else they go on where there is no smoke. Motion and
                                ///< what is measured is always straight.
    NormalGreen normals = NormalGreen::OpenGl;
};

/// What the numbers of passes are divided by, so that they lie between 0 and 1, or -1 and 1; one for all pictures that
/// belong together.
struct PassScales {
    float light = 1.0F; ///< of the maps of six-way light: 1, or more where there is more light
    float density = 1.0F; ///< the largest optical depth
    float motion = 1.0F; ///< the largest component, as a share of a cell
    float emission = 1.0F; ///< 1, or more where there is more
    float glow = 0.0F; ///< the brightest channel of what glows, which the ramp's 1 is; 0: nothing does
    GlowRamp ramp; ///< the colours of the map of what glows
    float temperature = 1.0F; ///< the hottest
    float nearest = 0.0F; ///< depth that is 0, m
    float farthest = 1.0F; ///< depth that is 1, m
};

/// The targets of the pictures of one sheet, side by side.
struct PassSheet {
    PassImages targets; ///< premultiplied
    SheetGrid grid;
    std::vector<LayerMask> masks{}; ///< where the pass is asked for, one a layer
};

/// Makes the pictures of passes from the targets of a sheet: numbers in [0, 1], but for motion and normals, whose are
/// in [-1, 1]. The same bits for any thread count.
class PassPictures {
public:
    /// Divides the targets by their alpha, fits the vectors to the colours, and finds the scales.
    /// @param sheet  must stay; motion needs the target of the colour too
    /// O(pixels).
    PassPictures(const PassSheet& sheet, PassSet passes, const PassStyle& style)
        : PassPictures(sheet, nullptr, passes, style)
    {
    }
    /// The same, dividing where the targets lie: what the sheet has but the colour is spent, and memory for copies is
    /// not asked for.
    [[nodiscard]] static PassPictures spending(PassSheet& sheet, PassSet passes, const PassStyle& style)
    {
        return {sheet, &sheet, passes, style};
    }

    /// What the numbers of all pictures were divided by.
    [[nodiscard]] const PassScales& scales() const { return m_scales; }
    /// @param pass one of the passes but the colour and the masks of layers
    /// O(pixels).
    [[nodiscard]] DataImage picture(Pass pass) const;

private:
    /// @param spent the sheet, where its targets may be taken
    PassPictures(const PassSheet& sheet, PassSheet* spent, PassSet passes, const PassStyle& style);
    [[nodiscard]] const Image& straight(PassTarget target) const
    {
        return m_straight[static_cast<std::size_t>(target)];
    }
    [[nodiscard]] const Image& written(PassTarget target) const
    {
        return m_style.premultiplied ? m_sheet.targets.of(target) : straight(target);
    }
    void findScales(PassSet passes);
    [[nodiscard]] DataImage sixWay(std::size_t map) const;
    [[nodiscard]] DataImage motion() const;
    [[nodiscard]] DataImage density() const;
    [[nodiscard]] float emissive(std::size_t pixel) const;
    [[nodiscard]] DataImage normal() const;
    [[nodiscard]] DataImage measured(const Image& image, std::size_t channel, float zero, float one) const;
    [[nodiscard]] DataImage colours(PassTarget target, float scale) const;

    const PassSheet& m_sheet;
    PassStyle m_style;
    std::array<Image, kPassTargets> m_straight;
    Image m_motion; ///< as engines take it, where it is asked for
    PassScales m_scales;
};

} // namespace fumage
