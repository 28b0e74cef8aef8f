#include "core/export/templates/template_facts.h"

#include "core/base/base64.h"
#include "core/base/text.h"

#include <algorithm>
#include <cassert>
#include <cctype>

#include <kainjow/mustache.hpp>

namespace fumage {

using kainjow::mustache::data;
using kainjow::mustache::mustache;

struct TemplateFacts::Data {
    data facts;
};

namespace {

bool isPlainWord(std::string_view word)
{
    return std::all_of(word.begin(), word.end(), [](unsigned char c) {
        return c < 128
            && (std::isalnum(c) != 0 || std::string_view(".-+_:").find(static_cast<char>(c)) != std::string_view::npos);
    });
}

} // namespace

TemplateFacts::TemplateFacts(Language language)
    : m_language(language)
    , m_data(std::make_unique<Data>())
{
}

TemplateFacts::TemplateFacts(TemplateFacts&&) noexcept = default;
TemplateFacts& TemplateFacts::operator=(TemplateFacts&&) noexcept = default;
TemplateFacts::~TemplateFacts() = default;

void TemplateFacts::text(const std::string& key, std::string_view value)
{
    m_data->facts.set(key, written(m_language, value));
}

void TemplateFacts::label(const std::string& key, std::string_view value)
{
    // What has quotes has escapes for letters; a comment of a shell and a line "key=value" take labels as they are.
    const bool isBare = m_language == Language::Shell || m_language == Language::KeyValue;
    m_data->facts.set(key, isBare ? labelOf(value) : written(m_language, labelOf(value)));
}

void TemplateFacts::identifier(const std::string& key, std::string_view value)
{
    m_data->facts.set(key, identifierOf(value));
}

void TemplateFacts::word(const std::string& key, std::string_view value)
{
    assert(isPlainWord(value));
    m_data->facts.set(key, isPlainWord(value) ? std::string(value) : std::string());
}

void TemplateFacts::number(const std::string& key, double value)
{
    m_data->facts.set(key, formatFloat(static_cast<float>(value)));
}

void TemplateFacts::number(const std::string& key, int value)
{
    m_data->facts.set(key, std::to_string(value));
}

void TemplateFacts::flag(const std::string& key, bool value)
{
    m_data->facts.set(key, value);
}

void TemplateFacts::list(const std::string& key, std::vector<TemplateFacts> items)
{
    data all = data::type::list;
    for (std::size_t i = 0; i < items.size(); ++i) {
        assert(items[i].m_language == m_language);
        items[i].flag("last", i + 1 == items.size());
        all << items[i].m_data->facts;
    }
    m_data->facts.set(key, all);
}

void TemplateFacts::bytes(const std::string& key, std::span<const std::byte> value)
{
    m_data->facts.set(key, data(kainjow::mustache::lambda([value](const std::string&) { return base64Of(value); })));
}

std::string TemplateFacts::fill(const EmbeddedFile& file) const
{
    mustache text{std::string(file.contents)};
    text.set_custom_escape(
        [](const std::string& value) { return value; }); // what is put in is written as the language has it
    assert(text.is_valid());
    return text.render(m_data->facts);
}

} // namespace fumage
