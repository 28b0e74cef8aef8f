#include "core/export/sheets/sheet_reader.h"

#include "core/base/memory.h"
#include "core/image_io/picture_pixels.h"
#include "core/preset/json_tree.h"
#include "core/rendering/view_transform.h"
#include "core/system/file.h"
#include "core/system/path.h"

#include <cmath>
#include <span>
#include <vector>

namespace fumage {

namespace {

constexpr std::size_t kMaxDescriptionBytes = std::size_t{1} << 22U;
constexpr std::size_t kMaxPictureBytes = std::size_t{1} << 29U;
constexpr int kMaxRate = 1000; ///< cells a second
constexpr float kMaxScale = 64.0F; ///< of vectors, shares of a cell
constexpr float kFull = 65535.0F;

/// Reads what a description says; every number has its bounds.
class Description {
public:
    Description(const JsonNode& root, std::string_view text, std::string place)
        : m_root(root)
        , m_text(text)
        , m_place(std::move(place))
    {
    }

    /// @return a whole number from 1 to a largest one
    [[nodiscard]] Result<int> count(std::string_view key, int largest) const
    {
        const JsonNode* node = m_root.find(key);
        if (node == nullptr || node->type != JsonNode::Type::Number || !node->isWhole || node->number < 1
            || node->number > largest) {
            return wrong(node, makeMessage("%1 is no whole number from 1 to %2", std::string(key), largest));
        }
        return static_cast<int>(node->number);
    }

    [[nodiscard]] Result<double> rate() const
    {
        const JsonNode* node = m_root.find("cells_per_second");
        if (node == nullptr || node->type != JsonNode::Type::Number || node->number <= 0.0 || node->number > kMaxRate) {
            return wrong(node, makeMessage("cells_per_second is no number above 0, %1 at most", kMaxRate));
        }
        return node->number;
    }

    [[nodiscard]] bool loops() const
    {
        const JsonNode* node = m_root.find("loop");
        return node != nullptr && node->type == JsonNode::Type::Bool && node->flag;
    }

    /// The picture of a pass; null: there is none.
    [[nodiscard]] const JsonNode* picture(Pass pass) const
    {
        const JsonNode* pictures = m_root.find("pictures");
        if (pictures == nullptr || pictures->type != JsonNode::Type::Array) {
            return nullptr;
        }
        for (const JsonNode& each : pictures->items) {
            const JsonNode* name = each.type == JsonNode::Type::Object ? each.find("pass") : nullptr;
            if (name != nullptr && name->string == passName(pass)) {
                return &each;
            }
        }
        return nullptr;
    }

    /// The file of a picture, a name without folders.
    [[nodiscard]] Result<std::filesystem::path> fileOf(const JsonNode& picture) const
    {
        const JsonNode* file = picture.find("file");
        const std::filesystem::path path = pathFrom(file != nullptr ? file->string : std::string());
        if (path.empty() || path.is_absolute() || path.has_parent_path() || path == "." || path == "..") {
            return wrong(&picture, makeMessage("a picture has no name of a file beside it"));
        }
        return path;
    }

    [[nodiscard]] Error wrong(const JsonNode* node, const Message& message) const
    {
        return {ErrorCode::OutOfRange, message,
            placeInFile(m_place, placeInText(m_text, node != nullptr ? node->begin : m_root.begin)),
            makeMessage("Export the flipbook anew")};
    }

private:
    const JsonNode& m_root;
    std::string_view m_text;
    std::string m_place;
};

/// The pixels of a picture that is as large as its grid says.
Result<RgbaPixels> readSheetPixels(const std::filesystem::path& file, const SheetGrid& grid, int rows)
{
    const Result<std::string> bytes = readFile(file, kMaxPictureBytes);
    if (!bytes) {
        return bytes.error();
    }
    Result<RgbaPixels> pixels = readPixels(std::as_bytes(std::span(bytes.value())));
    if (!pixels) {
        Error error = pixels.error();
        error.place = file.string();
        return error;
    }
    if (pixels.value().width != grid.columns * grid.cellWidth || pixels.value().height != rows * grid.cellHeight) {
        return Error{ErrorCode::OutOfRange, makeMessage("the picture has another size than its description says"),
            file.string(), makeMessage("Export the flipbook anew")};
    }
    return pixels;
}

/// The light that 16 bits of sRGB stand for, a table of it: a power a pixel would take seconds.
std::vector<float> linearOfWords()
{
    std::vector<float> out(std::size_t{1} << 16U);
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = linearFromSrgb(static_cast<float>(i) / kFull);
    }
    return out;
}

/// @param isStraight colours are not multiplied by alpha yet
void takeColours(const RgbaPixels& pixels, bool isStraight, Image& colour)
{
    const std::vector<float> linear = linearOfWords();
    colour.resize(pixels.width, pixels.height);
    for (std::size_t i = 0; i < pixels.values.size(); i += 4) {
        const float alpha = static_cast<float>(pixels.values[i + 3]) / kFull;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            colour.pixels[i + channel] = linear[pixels.values[i + channel]] * (isStraight ? alpha : 1.0F);
        }
        colour.pixels[i + 3] = alpha;
    }
}

/// Vectors as Unity has them, to the right and up, whatever signs the file has.
DataImage vectorsOf(const RgbaPixels& pixels, bool pointsLeft)
{
    DataImage motion{pixels.width, pixels.height, 3, true, {}};
    motion.values.resize(pixels.values.size() / 4 * 3);
    const auto number = [](std::uint16_t word) { return 2.0F * static_cast<float>(word) / kFull - 1.0F; };
    for (std::size_t from = 0, to = 0; from < pixels.values.size(); from += 4, to += 3) {
        const float right = number(pixels.values[from]);
        motion.values[to] = pointsLeft ? -right : right;
        motion.values[to + 1] = number(pixels.values[from + 1]);
        motion.values[to + 2] = 0.0F;
    }
    return motion;
}

bool hasText(const JsonNode& node, std::string_view key, std::string_view text)
{
    const JsonNode* found = node.find(key);
    return found != nullptr && found->string == text;
}

/// Grid and speed.
/// @return how many rows
Result<int> readGrid(const Description& description, std::int64_t mostPixels, SheetPreview& preview)
{
    const Result<int> columns = description.count("columns", kMaxSheetCells);
    const Result<int> rows = description.count("rows", kMaxSheetCells);
    const Result<int> width = description.count("cell_width", kMaxSheetEdge);
    const Result<int> height = description.count("cell_height", kMaxSheetEdge);
    for (const Result<int>* each : {&columns, &rows, &width, &height}) {
        if (!*each) {
            return each->error();
        }
    }
    const Result<double> rate = description.rate();
    if (!rate) {
        return rate.error();
    }
    const std::int64_t pixels =
        std::int64_t{columns.value()} * width.value() * (std::int64_t{rows.value()} * height.value());
    if (pixels > mostPixels) {
        return Error{ErrorCode::TooLarge,
            makeMessage("the sheet has %1 x %2 pixels, which is more than can be played here",
                columns.value() * width.value(), rows.value() * height.value()),
            {}, {}};
    }
    preview.sheet.grid = {
        columns.value(), columns.value() * rows.value(), width.value(), height.value(), description.loops()};
    preview.cellsPerSecond = rate.value();
    preview.output.width = width.value();
    preview.output.height = height.value();
    preview.output.exposure = 0.0F;
    preview.output.viewTransform = ViewTransform::Standard;
    preview.output.background = Background::Transparent;
    return rows.value();
}

/// The colours, without which there is nothing to play.
Status readColours(const Description& description, const std::filesystem::path& folder, int rows, SheetPreview& preview)
{
    const JsonNode* colour = description.picture(Pass::Colour);
    if (colour == nullptr) {
        return description.wrong(nullptr, makeMessage("the flipbook has no picture of its colours"));
    }
    const Result<std::filesystem::path> file = description.fileOf(*colour);
    if (!file) {
        return file.error();
    }
    const Result<RgbaPixels> pixels = readSheetPixels(folder / file.value(), preview.sheet.grid, rows);
    if (!pixels) {
        return pixels.error();
    }
    takeColours(
        pixels.value(), !hasText(*colour, "alpha", "premultiplied"), preview.sheet.targets.of(PassTarget::Colour));
    return Done{};
}

/// What plays it: with vectors, where it has them.
Status readPlayback(
    const Description& description, const std::filesystem::path& folder, int rows, SheetPreview& preview)
{
    const JsonNode* motion = description.picture(Pass::Motion);
    if (motion == nullptr) {
        preview.playback = std::make_unique<SheetPlayback>(preview.sheet);
        return Done{};
    }
    const JsonNode* scale = motion->find("scale");
    if (scale == nullptr || scale->type != JsonNode::Type::Number || std::abs(scale->number) > double{kMaxScale}) {
        return description.wrong(motion, makeMessage("the motion vectors have no scale"));
    }
    const Result<std::filesystem::path> file = description.fileOf(*motion);
    if (!file) {
        return file.error();
    }
    const Result<RgbaPixels> pixels = readSheetPixels(folder / file.value(), preview.sheet.grid, rows);
    if (!pixels) {
        return pixels.error();
    }
    preview.playback = std::make_unique<SheetPlayback>(preview.sheet,
        vectorsOf(pixels.value(), hasText(*motion, "signs", nameOf(VectorSigns::Unreal))),
        static_cast<float>(scale->number));
    return Done{};
}

} // namespace

Result<std::shared_ptr<const SheetPreview>> readFlipbook(
    const std::filesystem::path& description, std::int64_t mostPixels)
{
    return withinMemory([&]() -> Result<std::shared_ptr<const SheetPreview>> {
        const Result<std::string> text = readFile(description, kMaxDescriptionBytes);
        if (!text) {
            return text.error();
        }
        const std::string place = description.string();
        const Result<JsonNode> root = parseJsonOf(place, text.value());
        if (!root) {
            return root.error();
        }
        const Description read(root.value(), text.value(), place);
        if (root.value().type != JsonNode::Type::Object || !hasText(root.value(), "format", "fumage-flipbook")) {
            return read.wrong(nullptr, makeMessage("this is no description of a flipbook"));
        }
        auto preview = std::make_shared<SheetPreview>();
        const Result<int> rows = readGrid(read, mostPixels, *preview);
        if (!rows) {
            return rows.error();
        }
        const std::filesystem::path folder = description.parent_path();
        if (Status status = readColours(read, folder, rows.value(), *preview); !status) {
            return status.error();
        }
        if (Status status = readPlayback(read, folder, rows.value(), *preview); !status) {
            return status.error();
        }
        return std::shared_ptr<const SheetPreview>(std::move(preview));
    });
}

} // namespace fumage
