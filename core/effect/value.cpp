#include "core/effect/value.h"

#include "core/base/base64.h"
#include "core/base/joined.h"
#include "core/base/text.h"
#include "core/effect/parameter_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fumage {

namespace {

constexpr std::size_t kNumbersAVector = 3;
constexpr std::size_t kNumbersAPoint = 2;
constexpr std::size_t kNumbersAStop = 4;

Error wrongType(const Parameter& parameter, std::string_view found)
{
    return {ErrorCode::WrongType, makeMessage("expected %1, found %2", kindName(parameter.kind), inQuotes(found)),
        std::string(parameter.key), {}};
}

std::string join(std::initializer_list<float> numbers)
{
    std::string text;
    for (const float number : numbers) {
        text += (text.empty() ? "[" : ", ") + formatFloat(number);
    }
    return text + "]";
}

std::string formatList(const Curve& curve)
{
    std::string text;
    for (const CurvePoint& point : curve.points()) {
        text += (text.empty() ? "[" : ", ") + join({point.x, point.y});
    }
    return text + "]";
}

std::string formatList(const Gradient& gradient)
{
    std::string text;
    for (const GradientStop& stop : gradient.stops()) {
        text += (text.empty() ? "[" : ", ") + join({stop.at, stop.colour.r, stop.colour.g, stop.colour.b});
    }
    return text + "]";
}

Result<Clamped> parseChoice(const Parameter& parameter, std::string_view text)
{
    for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
        if (parameter.choices[i] == text) {
            return Clamped{static_cast<int>(i)};
        }
    }
    return Error{ErrorCode::UnknownName, makeMessage("there is no %1", inQuotes(text)), std::string(parameter.key),
        makeMessage("Choose one of %1", joined(parameter.choices))};
}

Result<Clamped> parsePicture(const Parameter& parameter, std::string_view text)
{
    if (text.empty()) {
        return Clamped{Bitmap()};
    }
    const std::optional<std::vector<std::byte>> bytes =
        text.size() <= base64Length(kMaxPictureBytes) ? bytesOfBase64(text) : std::vector<std::byte>();
    if (!bytes) {
        return wrongType(parameter, text);
    }
    if (bytes->empty()) {
        return Error{ErrorCode::TooLarge, makeMessage("a picture of %1 letters", text.size()),
            std::string(parameter.key), pictureRemedy()};
    }
    Result<Bitmap> picture = Bitmap::read(*bytes);
    if (picture) {
        return Clamped{std::move(picture).value()};
    }
    Error error = picture.error();
    error.place = std::string(parameter.key);
    return error;
}

Result<Clamped> parseBool(const Parameter& parameter, std::string_view text)
{
    if (text == "true" || text == "on" || text == "1") {
        return Clamped{true};
    }
    if (text == "false" || text == "off" || text == "0") {
        return Clamped{false};
    }
    return wrongType(parameter, text);
}

/// Whether the brackets of a text are those of the kind: none at all, or one pair around a vector and around each part
/// of a list.
bool bracketsFit(const Parameter& parameter, std::string_view text)
{
    std::string brackets;
    std::copy_if(text.begin(), text.end(), std::back_inserter(brackets), [](char c) { return c == '[' || c == ']'; });
    if (parameter.kind == Kind::Curve || parameter.kind == Kind::Gradient) {
        std::string expected = "[";
        while (expected.size() + 1 < brackets.size()) {
            expected += "[]";
        }
        return brackets.size() > 2 && brackets == expected + "]";
    }
    const bool isVector =
        parameter.kind == Kind::Direction || parameter.kind == Kind::Vector || parameter.kind == Kind::Colour;
    return brackets.empty() || (isVector && brackets == "[]");
}

Result<std::vector<double>> parseNumbers(const Parameter& parameter, std::string_view text)
{
    if (!bracketsFit(parameter, text)) {
        return wrongType(parameter, text);
    }
    std::string plain(text);
    std::replace_if(
        plain.begin(), plain.end(), [](char c) { return c == '[' || c == ']'; }, ' ');
    std::vector<double> numbers;
    const std::size_t count = splitCount(plain, ',');
    constexpr std::size_t kMaxNumbers = kMaxControlPoints * kNumbersAStop;
    for (std::size_t i = 0; i < count && i <= kMaxNumbers; ++i) {
        const std::optional<float> number = parseFloat(trimmed(splitPart(plain, ',', i)));
        if (!number) {
            return wrongType(parameter, text);
        }
        numbers.push_back(static_cast<double>(*number));
    }
    return numbers;
}

Result<Clamped> wholeNumber(const Parameter& parameter, double number)
{
    constexpr double kLargestInt = 2147483647.0;
    constexpr double kLargestSeed = 4294967295.0;
    if (number != std::floor(number)) {
        return wrongType(parameter, formatFloat(static_cast<float>(number)));
    }
    if (parameter.kind == Kind::Seed) {
        const double inside = std::clamp(number, 0.0, kLargestSeed);
        return Clamped{static_cast<std::uint32_t>(inside), inside != number};
    }
    const double inside = std::clamp(number, -kLargestInt, kLargestInt);
    return Clamped{static_cast<int>(inside), inside != number};
}

Value curveFrom(std::span<const double> numbers)
{
    Curve curve;
    for (std::size_t i = 0; i < numbers.size(); i += kNumbersAPoint) {
        curve.storage[static_cast<std::size_t>(curve.count++)] = {
            static_cast<float>(numbers[i]), static_cast<float>(numbers[i + 1])};
    }
    return curve;
}

Value gradientFrom(std::span<const double> numbers)
{
    Gradient gradient;
    for (std::size_t i = 0; i < numbers.size(); i += kNumbersAStop) {
        gradient.storage[static_cast<std::size_t>(gradient.count++)] = {
            static_cast<float>(numbers[i]), glm::vec3(numbers[i + 1], numbers[i + 2], numbers[i + 3])};
    }
    return gradient;
}

bool listFits(std::size_t count, std::size_t numbersEach)
{
    return count > 0 && count % numbersEach == 0 && count / numbersEach <= kMaxControlPoints;
}

float clampComponent(const Parameter& parameter, float value)
{
    return std::clamp(value, static_cast<float>(parameter.hard.low), static_cast<float>(parameter.hard.high));
}

/// Shorter vectors point nowhere.
constexpr float kShortestDirection = 1e-6F;

float largestComponent(const glm::vec3& value)
{
    return std::max({std::abs(value.x), std::abs(value.y), std::abs(value.z)});
}

/// Whether numbers say a direction, whatever their length.
bool isDirection(const Parameter& parameter, const glm::vec3& value)
{
    const glm::vec3 inside{
        clampComponent(parameter, value.x), clampComponent(parameter, value.y), clampComponent(parameter, value.z)};
    return inside == value && largestComponent(value) >= kShortestDirection;
}

glm::vec3 clampVector(const Parameter& parameter, const glm::vec3& value)
{
    if (parameter.kind != Kind::Direction) {
        return {
            clampComponent(parameter, value.x), clampComponent(parameter, value.y), clampComponent(parameter, value.z)};
    }
    const float largest = largestComponent(value);
    if (largest < kShortestDirection) {
        return std::get<glm::vec3>(parameter.get(Effect{}));
    }
    const glm::vec3 scaled = value / largest;
    const float length = std::sqrt(scaled.x * scaled.x + scaled.y * scaled.y + scaled.z * scaled.z);
    const float wanted = std::sqrt(value.x * value.x + value.y * value.y + value.z * value.z);
    constexpr float kRoundingOfAUnitVector = 1e-5F;
    return std::abs(wanted - 1.0F) < kRoundingOfAUnitVector ? value : scaled / length;
}

Curve clampCurve(const Parameter& parameter, Curve curve)
{
    const auto used = std::span(curve.storage).first(static_cast<std::size_t>(curve.count));
    for (CurvePoint& point : used) {
        point = {std::clamp(point.x, 0.0F, 1.0F), clampComponent(parameter, point.y)};
    }
    std::stable_sort(used.begin(), used.end(), [](const CurvePoint& a, const CurvePoint& b) { return a.x < b.x; });
    return curve;
}

Gradient clampGradient(const Parameter& parameter, Gradient gradient)
{
    const auto used = std::span(gradient.storage).first(static_cast<std::size_t>(gradient.count));
    for (GradientStop& stop : used) {
        stop.at = std::clamp(stop.at, 0.0F, 1.0F);
        for (int i = 0; i < 3; ++i) {
            stop.colour[i] = clampComponent(parameter, stop.colour[i]);
        }
    }
    std::stable_sort(
        used.begin(), used.end(), [](const GradientStop& a, const GradientStop& b) { return a.at < b.at; });
    return gradient;
}

} // namespace

std::string formatJson(const Parameter& parameter, const Value& value)
{
    switch (parameter.kind) {
    case Kind::Bool: return std::get<bool>(value) ? "true" : "false";
    case Kind::Int: return std::to_string(std::get<int>(value));
    case Kind::Float: return formatFloat(std::get<float>(value));
    case Kind::Choice:
        return '"' + std::string(parameter.choices[static_cast<std::size_t>(std::get<int>(value))]) + '"';
    case Kind::Seed: return std::to_string(std::get<std::uint32_t>(value));
    case Kind::Direction:
    case Kind::Vector:
    case Kind::Colour: {
        const auto& v = std::get<glm::vec3>(value);
        return join({v.x, v.y, v.z});
    }
    case Kind::Curve: return formatList(std::get<Curve>(value));
    case Kind::Gradient: return formatList(std::get<Gradient>(value));
    case Kind::Picture: return '"' + base64Of(std::get<Bitmap>(value).file()) + '"';
    }
    return {};
}

std::string formatText(const Parameter& parameter, const Value& value, bool withUnit)
{
    if (parameter.kind == Kind::Picture && withUnit) {
        const auto& picture = std::get<Bitmap>(value);
        return picture.empty() ? "none"
                               : std::to_string(picture.width()) + " x " + std::to_string(picture.height()) + " px";
    }
    std::string text = formatJson(parameter, value);
    std::erase(text, '"');
    const std::string_view unit = unitSymbol(parameter.unit);
    if (withUnit && !unit.empty()) {
        text += (parameter.unit == Unit::Degrees ? "" : " ") + std::string(unit);
    }
    return text;
}

Result<Clamped> parseValue(const Parameter& parameter, std::string_view text)
{
    text = trimmed(text);
    if (parameter.kind == Kind::Choice) {
        return parseChoice(parameter, text);
    }
    if (parameter.kind == Kind::Bool) {
        return parseBool(parameter, text);
    }
    if (parameter.kind == Kind::Picture) {
        return parsePicture(parameter, text);
    }
    if (parameter.kind == Kind::Int || parameter.kind == Kind::Seed) {
        // Whole numbers do not go through float, which holds only 24 bits of them.
        if (const std::optional<std::int64_t> number = parseInteger(text)) {
            return wholeNumber(parameter, static_cast<double>(*number));
        }
    }
    const Result<std::vector<double>> numbers = parseNumbers(parameter, text);
    return numbers ? valueFromNumbers(parameter, numbers.value()) : numbers.error();
}

Result<Clamped> valueFromNumbers(const Parameter& parameter, std::span<const double> numbers)
{
    constexpr double kLargestFloat = 3.4028234e38;
    for (const double number : numbers) {
        if (!(std::abs(number) <= kLargestFloat)) {
            return Error{ErrorCode::NotFinite, makeMessage("the number is not finite"), std::string(parameter.key),
                makeMessage("Use a plain number such as 1.5")};
        }
    }
    const std::string found = std::to_string(numbers.size()) + " numbers";
    switch (parameter.kind) {
    case Kind::Bool:
    case Kind::Choice:
    case Kind::Picture: return wrongType(parameter, found);
    case Kind::Int:
    case Kind::Seed: return numbers.size() == 1 ? wholeNumber(parameter, numbers[0]) : wrongType(parameter, found);
    case Kind::Float:
        return numbers.size() == 1 ? Result<Clamped>(Clamped{static_cast<float>(numbers[0])})
                                   : wrongType(parameter, found);
    case Kind::Direction:
    case Kind::Vector:
    case Kind::Colour:
        return numbers.size() == kNumbersAVector
            ? Result<Clamped>(Clamped{glm::vec3(numbers[0], numbers[1], numbers[2])})
            : wrongType(parameter, found);
    case Kind::Curve:
        return listFits(numbers.size(), kNumbersAPoint) ? Result<Clamped>(Clamped{curveFrom(numbers)})
                                                        : wrongType(parameter, found);
    case Kind::Gradient:
        return listFits(numbers.size(), kNumbersAStop) ? Result<Clamped>(Clamped{gradientFrom(numbers)})
                                                       : wrongType(parameter, found);
    }
    return wrongType(parameter, found);
}

Clamped clampValue(const Parameter& parameter, const Value& value)
{
    Value clamped = value;
    switch (parameter.kind) {
    case Kind::Bool: break;
    case Kind::Choice:
        clamped = std::clamp(std::get<int>(value), 0, static_cast<int>(parameter.choices.size()) - 1);
        break;
    case Kind::Int:
        clamped = std::clamp(
            std::get<int>(value), static_cast<int>(parameter.hard.low), static_cast<int>(parameter.hard.high));
        break;
    case Kind::Seed:
    case Kind::Picture: break;
    case Kind::Float: clamped = clampComponent(parameter, std::get<float>(value)); break;
    case Kind::Direction:
    case Kind::Vector:
    case Kind::Colour: clamped = clampVector(parameter, std::get<glm::vec3>(value)); break;
    case Kind::Curve: clamped = clampCurve(parameter, std::get<Curve>(value)); break;
    case Kind::Gradient: clamped = clampGradient(parameter, std::get<Gradient>(value)); break;
    }
    return {clamped,
        parameter.kind == Kind::Direction ? !isDirection(parameter, std::get<glm::vec3>(value)) : clamped != value};
}

std::vector<const Parameter*> differences(const Effect& a, const Effect& b)
{
    std::vector<const Parameter*> rows;
    for (const Parameter& parameter : parameterTable()) {
        if (parameter.get(a) != parameter.get(b)) {
            rows.push_back(&parameter);
        }
    }
    return rows;
}

bool setClamped(Effect& effect, const Parameter& parameter, const Value& value)
{
    const Clamped clamped = clampValue(parameter, value);
    parameter.set(effect, clamped.value);
    return clamped.changed;
}

bool setClamped(Effect& effect, const Parameter& parameter, const Clamped& read)
{
    return setClamped(effect, parameter, read.value) || read.changed;
}

} // namespace fumage
