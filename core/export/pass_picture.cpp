#include "core/export/pass_picture.h"

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/export/sheets/motion_fill.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

namespace fumage {

namespace {

/// Less smoke than this does not say what it looks like: what is around it does.
constexpr float kEnough = 1.0F / 255.0F;
/// Single particles at the rim go their own ways; the flow is that of all.
constexpr float kEnoughToFlow = 1.0F / 16.0F;
/// Less than half a step of 8 bits is not seen, and decides nothing.
constexpr float kSeen = 0.5F / 255.0F;

/// The largest value(pixel) of a picture, but not less than something.
template <class Value>
float largestOf(const Image& image, float least, const Value& value)
{
    std::vector<float> rows(static_cast<std::size_t>(image.height), least);
    parallelFor(rows.size(), [&](std::size_t y) {
        const float* pixel = image.row(static_cast<int>(y));
        float most = least;
        for (int x = 0; x < image.width; ++x, pixel += 4) {
            most = std::max(most, value(pixel));
        }
        rows[y] = most;
    });
    return std::accumulate(rows.begin(), rows.end(), least, [](float a, float b) { return std::max(a, b); });
}

/// What lets a share 1 - alpha of the light through: each particle multiplies that share, and adds to this.
float opticalDepth(float alpha)
{
    constexpr float kMinThrough = 0x1p-23F; // the next alpha below 1
    return alpha > 0.0F ? -portableLog(std::max(kMinThrough, 1.0F - alpha)) : 0.0F;
}

/// Makes a picture of values(index of the pixel, where they go).
template <class Values>
DataImage filled(const Image& like, int channels, bool isSigned, const Values& values)
{
    DataImage out{like.width, like.height, channels, isSigned, {}};
    out.values.resize(static_cast<std::size_t>(like.width) * static_cast<std::size_t>(like.height)
        * static_cast<std::size_t>(channels));
    const auto width = static_cast<std::size_t>(like.width);
    parallelFor(static_cast<std::size_t>(like.height), [&](std::size_t y) {
        for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
            values(i, out.values.data() + i * static_cast<std::size_t>(channels));
        }
    });
    return out;
}

} // namespace

std::array<std::array<SixWayChannel, 4>, 2> channelsOf(SixWayLayout layout)
{
    using enum SixWayChannel;
    switch (layout) {
    case SixWayLayout::Unity: break;
    case SixWayLayout::EmberGen: return {{{Top, Left, Right, Alpha}, {Bottom, Back, Front, Alpha}}};
    case SixWayLayout::RltBbf: return {{{Right, Left, Top, Alpha}, {Bottom, Back, Front, Alpha}}};
    case SixWayLayout::TlrbFb: return {{{Top, Left, Right, Bottom}, {Front, Back, Nothing, Alpha}}};
    }
    return {{{Right, Top, Back, Alpha}, {Left, Bottom, Front, Emissive}}};
}

std::string_view nameOf(SixWayChannel channel)
{
    constexpr std::array<std::string_view, 9> kNames{
        "right", "left", "top", "bottom", "back", "front", "alpha", "emissive", "nothing"};
    return kNames[static_cast<std::size_t>(channel)];
}

std::string_view nameOf(SixWayLayout layout)
{
    constexpr std::array<std::string_view, 4> kNames{"unity", "embergen", "rlt-bbf", "tlrb-fb"};
    return kNames[static_cast<std::size_t>(layout)];
}

std::string_view nameOf(VectorSigns signs)
{
    return signs == VectorSigns::Unity ? "unity" : "unreal";
}

std::string_view nameOf(NormalGreen green)
{
    return green == NormalGreen::OpenGl ? "opengl" : "directx";
}

std::string fileNameOf(Pass pass)
{
    std::string name(passName(pass));
    if (name.starts_with("six-way")) {
        name.replace(0, std::string_view("six-way").size(), "sixway"); // as other tools write it
    }
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

PassPictures::PassPictures(const PassSheet& sheet, PassSheet* spent, PassSet passes, const PassStyle& style)
    : m_sheet(sheet)
    , m_style(style)
{
    const auto straight = [&](PassTarget target, float enough, bool last) {
        Image image;
        if (spent != nullptr && last) {
            image = std::move(spent->targets.of(target));
        } else {
            image = sheet.targets.of(target);
        }
        straighten(image, sheet.grid.cellWidth, sheet.grid.cellHeight, enough);
        return image;
    };
    for (const PassTarget target : {PassTarget::RightTopBack, PassTarget::LeftBottomFront, PassTarget::Emission,
             PassTarget::Albedo, PassTarget::Inner}) {
        if (needsTarget(passes, target)) {
            m_straight[static_cast<std::size_t>(target)] = straight(target, kEnough, !style.premultiplied);
        }
    }
    if (passes.has(Pass::Depth)) {
        m_straight[static_cast<std::size_t>(PassTarget::Motion)] =
            straight(PassTarget::Motion, kEnough, !passes.has(Pass::Motion));
    }
    if (passes.has(Pass::Motion)) {
        m_motion = straight(PassTarget::Motion, kEnoughToFlow, true);
        refineMotion(sheet.targets.of(PassTarget::Colour), sheet.grid, m_motion);
    }
    findScales(passes);
}

void PassPictures::findScales(PassSet passes)
{
    const auto largest = [&](PassTarget target, float least) {
        return largestOf(straight(target), least, [](const float* p) {
            return p[3] < kSeen ? 0.0F : std::max({p[0], p[1], p[2]});
        });
    };
    m_scales.light = largest(PassTarget::LeftBottomFront, largest(PassTarget::RightTopBack, m_scales.light));
    m_scales.glow = largest(PassTarget::Emission, 0.0F);
    m_scales.emission = std::max(m_scales.emission, m_scales.glow);
    if (passes.has(Pass::SixWayB)) {
        m_scales.ramp = fitGlowRamp(straight(PassTarget::Emission), m_scales.glow);
    }
    if (passes.has(Pass::Temperature)) {
        const float hottest =
            largestOf(straight(PassTarget::Inner), 0.0F, [](const float* p) { return p[3] < kSeen ? 0.0F : p[0]; });
        m_scales.temperature = hottest > 0.0F ? hottest : 1.0F;
    }
    if (passes.has(Pass::Density)) {
        const float most = largestOf(m_sheet.targets.of(PassTarget::Colour), 0.0F, [](const float* p) { return p[3]; });
        m_scales.density = std::max(opticalDepth(kSeen), opticalDepth(most));
    }
    if (passes.has(Pass::Motion)) {
        constexpr float kStill = 1e-6F;
        m_scales.motion =
            largestOf(m_motion, kStill, [](const float* p) { return std::max(std::abs(p[0]), std::abs(p[1])); });
    }
    if (passes.has(Pass::Depth)) {
        constexpr float kFar = std::numeric_limits<float>::max();
        const Image& places = straight(PassTarget::Motion);
        const float low = -largestOf(places, -kFar, [](const float* p) { return p[3] < kSeen ? -kFar : -p[2]; });
        const float high = largestOf(places, 0.0F, [](const float* p) { return p[3] < kSeen ? 0.0F : p[2]; });
        m_scales.nearest = low < high ? low : 0.0F;
        m_scales.farthest = low < high ? high : 1.0F;
    }
}

DataImage PassPictures::sixWay(std::size_t map) const
{
    const std::array<std::array<SixWayChannel, 4>, 2> maps = channelsOf(m_style.layout);
    const float share = 1.0F / m_scales.light;
    const Image& above = written(PassTarget::RightTopBack);
    const Image& below = written(PassTarget::LeftBottomFront);
    return filled(above, 4, false, [&](std::size_t i, float* to) {
        const float* a = above.pixels.data() + i * 4;
        const float* b = below.pixels.data() + i * 4;
        for (const SixWayChannel channel : maps[map]) {
            switch (channel) {
            case SixWayChannel::Right: *to = a[0] * share; break;
            case SixWayChannel::Top: *to = a[1] * share; break;
            case SixWayChannel::Back: *to = a[2] * share; break;
            case SixWayChannel::Left: *to = b[0] * share; break;
            case SixWayChannel::Bottom: *to = b[1] * share; break;
            case SixWayChannel::Front: *to = b[2] * share; break;
            case SixWayChannel::Alpha: *to = a[3]; break;
            case SixWayChannel::Emissive: *to = emissive(i); break;
            case SixWayChannel::Nothing: *to = 0.0F; break;
            }
            ++to;
        }
    });
}

/// Where on the ramp the light of a pixel's own lies.
float PassPictures::emissive(std::size_t pixel) const
{
    const float* light = written(PassTarget::Emission).pixels.data() + pixel * 4;
    return m_scales.glow > 0.0F ? glowPosition(std::max({light[0], light[1], light[2]}) / m_scales.glow) : 0.0F;
}

DataImage PassPictures::motion() const
{
    const float x = (m_style.vectors == VectorSigns::Unity ? 1.0F : -1.0F) / m_scales.motion;
    const float y = 1.0F / m_scales.motion;
    return filled(m_motion, 3, true, [&](std::size_t i, float* to) {
        to[0] = m_motion.pixels[i * 4] * x;
        to[1] = m_motion.pixels[i * 4 + 1] * y;
        to[2] = 0.0F;
    });
}

/// Light from one side less that from the other is how much a place faces there; what faces nothing looks at the eye.
DataImage PassPictures::normal() const
{
    const Image& above = straight(PassTarget::RightTopBack);
    const Image& below = straight(PassTarget::LeftBottomFront);
    const float green = m_style.normals == NormalGreen::OpenGl ? 1.0F : -1.0F;
    return filled(above, 3, true, [&](std::size_t i, float* to) {
        const float* a = above.pixels.data() + i * 4;
        const float* b = below.pixels.data() + i * 4;
        const glm::vec3 facing(a[0] - b[0], a[1] - b[1], std::max(0.0F, b[2] - a[2]));
        const float length = std::sqrt(glm::dot(facing, facing));
        constexpr float kFlat = 1e-6F;
        glm::vec3 normal = length > kFlat ? facing / length : glm::vec3(0.0F, 0.0F, 1.0F);
        normal.y *= green;
        std::copy_n(&normal.x, 3, to);
    });
}

DataImage PassPictures::density() const
{
    const Image& smoke = m_sheet.targets.of(PassTarget::Colour);
    const float share = 1.0F / m_scales.density;
    return filled(
        smoke, 1, false, [&](std::size_t i, float* to) { *to = opticalDepth(smoke.pixels[i * 4 + 3]) * share; });
}

/// One channel, shifted and scaled.
DataImage PassPictures::measured(const Image& image, std::size_t channel, float zero, float one) const
{
    const float share = 1.0F / (one - zero);
    return filled(
        image, 1, false, [&](std::size_t i, float* to) { *to = (image.pixels[i * 4 + channel] - zero) * share; });
}

DataImage PassPictures::colours(PassTarget target, float scale) const
{
    const Image& image = written(target);
    const float share = 1.0F / scale;
    return filled(image, 4, false, [&](std::size_t i, float* to) {
        const float* from = image.pixels.data() + i * 4;
        std::transform(from, from + 3, to, [&](float value) { return value * share; });
        to[3] = from[3];
    });
}

DataImage PassPictures::picture(Pass pass) const
{
    switch (pass) {
    case Pass::Colour:
    case Pass::LayerMasks: break;
    case Pass::Alpha: return measured(m_sheet.targets.of(PassTarget::Colour), 3, 0.0F, 1.0F);
    case Pass::Density: return density();
    case Pass::SixWayA: return sixWay(0);
    case Pass::SixWayB: return sixWay(1);
    case Pass::Motion: return motion();
    case Pass::Normal: return normal();
    case Pass::Depth: return measured(straight(PassTarget::Motion), 2, m_scales.nearest, m_scales.farthest);
    case Pass::Emission: return colours(PassTarget::Emission, m_scales.emission);
    case Pass::Albedo: return colours(PassTarget::Albedo, 1.0F);
    case Pass::Temperature: return measured(straight(PassTarget::Inner), 0, 0.0F, m_scales.temperature);
    case Pass::Shadow: return measured(straight(PassTarget::Inner), 1, 0.0F, 1.0F);
    }
    return {};
}

} // namespace fumage
