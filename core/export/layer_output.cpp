#include "core/export/layer_output.h"

#include "core/base/text.h"

#include <algorithm>
#include <set>

namespace fumage {

namespace {

constexpr std::size_t kLongestWord = 48; ///< bytes

bool isLetter(char letter)
{
    return static_cast<unsigned char>(letter) >= 0x80U || (letter >= 'a' && letter <= 'z')
        || (letter >= '0' && letter <= '9');
}

/// Cut where no letter of several bytes is.
void shorten(std::string& word)
{
    if (word.size() <= kLongestWord) {
        return;
    }
    std::size_t end = kLongestWord;
    while (end > 0 && (static_cast<unsigned char>(word[end]) & 0xc0U) == 0x80U) {
        --end;
    }
    word.resize(end);
}

/// What is left of a name: one dash for all between letters. Empty where nothing is, or it is no text.
std::string lettersOf(const std::string& name)
{
    if (!isUtf8(name)) {
        return {};
    }
    std::string word;
    for (const char letter : inSmallLetters(printable(name))) {
        if (isLetter(letter)) {
            word += letter;
        } else if (!word.empty() && word.back() != '-') {
            word += '-';
        }
    }
    shorten(word);
    word.erase(word.find_last_not_of('-') + 1);
    return word;
}

/// Letters beyond ASCII have cases and compositions that file systems take for the same.
bool isAscii(const std::string& word)
{
    return std::ranges::all_of(word, [](char letter) { return static_cast<unsigned char>(letter) < 0x80U; });
}

} // namespace

std::string_view nameOf(LayerOutput output)
{
    constexpr std::array<std::string_view, kLayerOutputs> kNames{"together", "alone", "contribution", "stacked"};
    return kNames[static_cast<std::size_t>(output)];
}

bool isShare(LayerOutput output)
{
    return output == LayerOutput::Contribution || output == LayerOutput::Stacked;
}

std::string_view nameOf(BlendSpace space)
{
    return space == BlendSpace::Encoded ? "encoded" : "linear";
}

std::vector<WrittenLayer> writtenLayers(const Scene& scene)
{
    std::vector<std::size_t> seen = scene.visibleLayers();
    if (seen.empty()) {
        seen.push_back(0);
    }
    std::vector<WrittenLayer> layers;
    std::set<std::string> words;
    for (const std::size_t index : seen) {
        const std::string number = "-" + std::to_string(index + 1);
        WrittenLayer layer{index, scene.layers[index].name, lettersOf(scene.layers[index].name)};
        if (layer.word.empty()) {
            layer.word = "layer" + number;
        } else if (!isAscii(layer.word)) {
            layer.word += number;
        }
        while (!words.insert(layer.word).second) {
            layer.word += number;
        }
        layers.push_back(std::move(layer));
    }
    return layers;
}

} // namespace fumage
