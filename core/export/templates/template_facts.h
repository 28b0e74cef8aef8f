#pragma once

#include "core/base/embedded_file.h"
#include "core/export/templates/language.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// What fills a template (Mustache) of one language. Nothing reaches the template but through these functions, and each
/// writes what it is given as the language has it: a template cannot ask for a text that is not escaped.
class TemplateFacts {
public:
    explicit TemplateFacts(Language language);
    TemplateFacts(TemplateFacts&&) noexcept;
    TemplateFacts& operator=(TemplateFacts&&) noexcept;
    ~TemplateFacts();

    [[nodiscard]] Language language() const { return m_language; }

    /// A text from outside: written().
    void text(const std::string& key, std::string_view value);
    /// A name that is only shown, also in comments: labelOf().
    void label(const std::string& key, std::string_view value);
    /// A name for programs: identifierOf().
    void identifier(const std::string& key, std::string_view value);
    /// A word of our own: letters, digits and ".-+_:" alone.
    void word(const std::string& key, std::string_view value);
    void number(const std::string& key, double value);
    void number(const std::string& key, int value);
    void flag(const std::string& key, bool value);
    /// What a section repeats; "last" is set in the last one.
    void list(const std::string& key, std::vector<TemplateFacts> items);
    /// Bytes in base 64, made only for the template that asks for them. They must stay.
    void bytes(const std::string& key, std::span<const std::byte> value);

    /// A template with what it asks for.
    /// @param file a template whose Mustache is right (asserted)
    [[nodiscard]] std::string fill(const EmbeddedFile& file) const;

private:
    struct Data;
    Language m_language;
    std::unique_ptr<Data> m_data;
};

} // namespace fumage
