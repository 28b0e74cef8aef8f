#include "core/export/sheets/packing.h"

#include "core/base/parallel.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <map>

namespace fumage {

namespace {

constexpr std::string_view kLetters = "rgba";

/// How many numbers a pass has for each pixel.
int numbersOf(Pass pass)
{
    switch (pass) {
    case Pass::LayerMasks: return 0; // they are no picture that channels are taken from
    case Pass::Alpha:
    case Pass::Density:
    case Pass::Depth:
    case Pass::Temperature:
    case Pass::Shadow: return 1;
    case Pass::Motion: return 2;
    case Pass::Normal: return 3;
    default: return 4;
    }
}

/// Small letters, and names as command lines have them: those of files and of other spellings are understood.
std::string normalised(std::string_view text)
{
    std::string out = inSmallLetters(text);
    std::replace(out.begin(), out.end(), '_', '-');
    if (out.starts_with("sixway")) {
        out.insert(3, "-");
    }
    if (out.starts_with("color")) {
        out.insert(4, "u");
    }
    return out;
}

Result<PackedChannel> parseChannel(std::string_view text)
{
    const std::string wanted = normalised(text);
    std::vector<std::string> names;
    for (const PackedChannel& channel : allChannels()) {
        names.push_back(textOf(channel));
        if (names.back() == wanted) {
            return channel;
        }
    }
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    const std::string_view near = nearestName(wanted, candidates);
    return Error{ErrorCode::UnknownName, makeMessage("there is no channel %1", inQuotes(text)), {},
        near.empty()
            ? makeMessage("Choose from alpha, density, depth, temperature, shadow, colour.r, six-way-a.r, "
                          "six-way-b.r, motion.r, normal.r, emission.r, albedo.r, their .g, .b and .a, 0 and 1")
            : makeMessage("Did you mean %1?", inQuotes(near))};
}

bool isLetterOrDigit(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

Status checkName(std::string_view name)
{
    constexpr std::size_t kLongest = 40;
    const bool isLegal =
        std::all_of(name.begin(), name.end(), [](char c) { return isLetterOrDigit(c) || c == '-' || c == '_'; });
    if (name.empty() || name.size() > kLongest || !isLegal || !isLetterOrDigit(name.front())) {
        return Error{ErrorCode::OutOfRange, makeMessage("a packed picture cannot be named %1", inQuotes(name)), {},
            makeMessage("Use up to %1 letters, digits, - and _", kLongest)};
    }
    const std::string plain = normalised(name);
    for (const Pass pass : kAllPasses) {
        if (plain == passName(pass)) {
            return Error{ErrorCode::OutOfRange, makeMessage("a packed picture cannot be named %1", inQuotes(name)), {},
                makeMessage("Choose another name: this is the name of a pass")};
        }
    }
    return Done{};
}

Status checkCount(std::string_view name, std::size_t channels)
{
    if (channels >= 1 && channels <= kLetters.size()) {
        return Done{};
    }
    return Error{ErrorCode::OutOfRange, makeMessage("the packed picture %1 has %2 channels", inQuotes(name), channels),
        {}, makeMessage("Use one to four: red, green, blue and alpha")};
}

/// Of "1/2" the 2.
std::optional<int> parseDivisor(std::string_view text)
{
    const std::optional<std::int64_t> number = text == "1" ? 1
        : text.starts_with("1/")                           ? parseInteger(text.substr(2))
                                                           : std::nullopt;
    return number && *number >= 1 && *number <= kMaxDivisor ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

/// Whether an average must be weighted by alpha: where there is little smoke its light says little.
bool isStraight(Pass pass, int channel, const PassStyle& style)
{
    const bool isAlpha = channel == 3;
    switch (pass) {
    case Pass::Colour:
    case Pass::Alpha:
    case Pass::Density: return false;
    case Pass::SixWayA:
    case Pass::SixWayB: {
        const SixWayChannel what =
            channelsOf(style.layout)[pass == Pass::SixWayA ? 0 : 1][static_cast<std::size_t>(channel)];
        return !style.premultiplied && what != SixWayChannel::Alpha;
    }
    case Pass::Emission:
    case Pass::Albedo: return !style.premultiplied && !isAlpha;
    default: return true;
    }
}

} // namespace

std::vector<PackedChannel> allChannels()
{
    std::vector<PackedChannel> all{{{}, 0, 0.0F}, {{}, 0, 1.0F}};
    for (const Pass pass : kAllPasses) {
        for (int i = 0; i < numbersOf(pass); ++i) {
            all.push_back({pass, i});
        }
    }
    return all;
}

std::string textOf(const PackedChannel& channel)
{
    if (!channel.pass) {
        return channel.constant > 0.0F ? "1" : "0";
    }
    const std::string name(passName(*channel.pass));
    return numbersOf(*channel.pass) == 1 ? name : name + "." + kLetters[static_cast<std::size_t>(channel.channel)];
}

std::string textOf(const PackedPicture& pack)
{
    std::string text = pack.name;
    for (std::size_t i = 0; i < pack.channels.size(); ++i) {
        text += (i == 0 ? "=" : ",") + textOf(pack.channels[i]);
    }
    return pack.divisor == 1 ? text : text + "@1/" + std::to_string(pack.divisor);
}

Result<PackedPicture> parsePack(std::string_view text)
{
    const std::size_t equals = text.find('=');
    const std::size_t at = std::min(text.rfind('@'), text.size());
    const std::optional<int> divisor = at == text.size() ? 1 : parseDivisor(trimmed(text.substr(at + 1)));
    if (equals == std::string_view::npos || at < equals || !divisor) {
        return Error{ErrorCode::Syntax, makeMessage("the packed picture %1 is not understood", inQuotes(text)), {},
            makeMessage(
                "Write masks=shadow,temperature,alpha, and @1/2 to @1/%1 after it for a smaller one", kMaxDivisor)};
    }
    PackedPicture pack{std::string(trimmed(text.substr(0, equals))), {}, *divisor};
    if (Status status = checkName(pack.name); !status) {
        return status.error();
    }
    const std::string_view list = text.substr(equals + 1, at - equals - 1);
    const std::size_t count = splitCount(list, ',');
    if (Status status = checkCount(pack.name, count); !status) {
        return status.error();
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Result<PackedChannel> channel = parseChannel(trimmed(splitPart(list, ',', i)));
        if (!channel) {
            return channel.error();
        }
        pack.channels.push_back(channel.value());
    }
    return pack;
}

PassSet passesOf(std::span<const PackedPicture> packs)
{
    PassSet passes;
    for (const PackedPicture& pack : packs) {
        for (const PackedChannel& channel : pack.channels) {
            if (channel.pass) {
                passes.add(*channel.pass);
            }
        }
    }
    return passes;
}

Status checkPacks(std::span<const PackedPicture> packs, int cellWidth, int cellHeight)
{
    if (packs.size() > kMaxPackedPictures) {
        return Error{ErrorCode::OutOfRange, makeMessage("there are %1 packed pictures", packs.size()), {},
            makeMessage("Use up to %1", kMaxPackedPictures)};
    }
    for (std::size_t i = 0; i < packs.size(); ++i) {
        if (Status status = checkName(packs[i].name); !status) {
            return status;
        }
        if (Status status = checkCount(packs[i].name, packs[i].channels.size()); !status) {
            return status;
        }
        const auto sameName = [&](const PackedPicture& other) {
            return normalised(other.name) == normalised(packs[i].name);
        };
        if (std::any_of(packs.begin(), packs.begin() + static_cast<std::ptrdiff_t>(i), sameName)) {
            return Error{ErrorCode::OutOfRange,
                makeMessage("two packed pictures are named %1", inQuotes(packs[i].name)), {},
                makeMessage("Choose another name")};
        }
        if (packs[i].divisor < 1 || cellWidth % packs[i].divisor != 0 || cellHeight % packs[i].divisor != 0) {
            return Error{ErrorCode::OutOfRange,
                makeMessage("cells of %1 x %2 pixels cannot be divided by %3, as %4 asks for", cellWidth, cellHeight,
                    packs[i].divisor, inQuotes(packs[i].name)),
                {}, makeMessage("Choose another size of a cell, or another part")};
        }
    }
    return Done{};
}

bool isSrgb(const PackedPicture& pack, ImageFormat format)
{
    const auto first = pack.channels.begin();
    const auto past = first + static_cast<std::ptrdiff_t>(std::min<std::size_t>(3, pack.channels.size()));
    const auto isColour = [](const PackedChannel& channel) {
        return channel.pass == Pass::Colour && channel.channel < 3;
    };
    return !holdsFloats(format) && std::any_of(first, past, isColour)
        && std::all_of(first, past, [&](const PackedChannel& channel) { return !channel.pass || isColour(channel); });
}

DataImage Packer::colour(int divisor) const
{
    const Image& image = m_sheet.targets.of(PassTarget::Colour);
    return sheetNumbers(divisor > 1 ? downsample(image, divisor) : image, m_scene, m_format,
        m_sheet.grid.cellWidth / divisor, m_sheet.grid.cellHeight / divisor);
}

/// Averages blocks of a pass's picture.
DataImage Packer::averaged(const DataImage& image, Pass pass, int divisor) const
{
    DataImage out{image.width / divisor, image.height / divisor, image.channels, image.isSigned, {}};
    out.values.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height)
        * static_cast<std::size_t>(out.channels));
    const Image& smoke = m_sheet.targets.of(PassTarget::Colour);
    std::array<bool, kLetters.size()> weighted{};
    for (int channel = 0; channel < out.channels; ++channel) {
        weighted[static_cast<std::size_t>(channel)] = isStraight(pass, channel, m_style);
    }
    const auto averageOf = [&](int left, int top, int channel) {
        double sum = 0.0;
        double weights = 0.0;
        double plain = 0.0;
        for (int y = top; y < top + divisor; ++y) {
            for (int x = left; x < left + divisor; ++x) {
                const double weight =
                    weighted[static_cast<std::size_t>(channel)] ? static_cast<double>(smoke.at(x, y).a) : 1.0;
                const double value = image.values[(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width)
                                                      + static_cast<std::size_t>(x))
                        * static_cast<std::size_t>(image.channels)
                    + static_cast<std::size_t>(channel)];
                sum += weight * value;
                weights += weight;
                plain += value;
            }
        }
        return static_cast<float>(weights > 0.0 ? sum / weights : plain / (divisor * divisor));
    };
    parallelFor(static_cast<std::size_t>(out.height), [&](std::size_t y) {
        float* to =
            out.values.data() + y * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.channels);
        for (int x = 0; x < out.width; ++x) {
            for (int channel = 0; channel < out.channels; ++channel) {
                *to++ = averageOf(x * divisor, static_cast<int>(y) * divisor, channel);
            }
        }
    });
    return out;
}

DataImage Packer::source(Pass pass, int divisor) const
{
    if (pass == Pass::Colour) {
        return colour(divisor);
    }
    DataImage image = m_pictures.picture(pass);
    if (divisor > 1) {
        image = averaged(image, pass, divisor);
    }
    if (image.isSigned && !holdsFloats(m_format)) {
        for (float& value : image.values) {
            value = 0.5F + 0.5F * value;
        }
    }
    return image;
}

DataImage Packer::pack(const PackedPicture& pack) const
{
    const int channels = static_cast<int>(pack.channels.size() == 2 ? 3 : pack.channels.size());
    DataImage out{m_sheet.targets.of(PassTarget::Colour).width / pack.divisor,
        m_sheet.targets.of(PassTarget::Colour).height / pack.divisor, channels, false, {}, isSrgb(pack, m_format)};
    const std::size_t pixels = static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height);
    out.values.assign(pixels * static_cast<std::size_t>(channels), 0.0F);
    std::map<Pass, DataImage> sources;
    for (std::size_t i = 0; i < pack.channels.size(); ++i) {
        const PackedChannel& channel = pack.channels[i];
        const auto to = [&](std::size_t pixel) -> float& {
            return out.values[pixel * static_cast<std::size_t>(channels) + i];
        };
        if (!channel.pass) {
            for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
                to(pixel) = channel.constant;
            }
            continue;
        }
        auto found = sources.find(*channel.pass);
        if (found == sources.end()) {
            found = sources.emplace(*channel.pass, source(*channel.pass, pack.divisor)).first;
        }
        const DataImage& from = found->second;
        for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
            to(pixel) = from.values[pixel * static_cast<std::size_t>(from.channels)
                + static_cast<std::size_t>(channel.channel)];
        }
    }
    return out;
}

} // namespace fumage
