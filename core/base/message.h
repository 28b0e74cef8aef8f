#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace fumage {

/// What is said to people: a sentence in plain English, in which %1 to %9 stand for numbers, names and other messages.
/// The sentence is also the id under which a program finds it in other languages, so it is a literal and made by
/// makeMessage() alone; what others have said is a message as it stands.
class Message {
public:
    Message() = default;
    /// A name, or a text of the system or of a library.
    Message(std::string text) // NOLINT(google-explicit-constructor): names are what places are made of
        : m_text(std::move(text))
    {
    }
    /// Sentences go through makeMessage(), or nobody would translate them.
    Message(const char* text) = delete;

    [[nodiscard]] bool empty() const { return m_sentence == nullptr && m_text.empty(); }

    /// In English.
    [[nodiscard]] std::string text() const
    {
        return text([](const char* sentence) { return std::string(sentence); });
    }

    /// @param inLanguage called with a sentence; returns the same in another language, as UTF-8
    template <class Translate>
    [[nodiscard]] std::string text(const Translate& inLanguage) const
    {
        if (m_sentence == nullptr) {
            return m_text;
        }
        const std::string sentence = inLanguage(m_sentence);
        std::string out;
        for (std::size_t i = 0; i < sentence.size(); ++i) {
            const std::size_t part = sentence[i] == '%' && i + 1 < sentence.size()
                ? static_cast<std::size_t>(sentence[i + 1] - '1')
                : m_parts.size();
            if (part < m_parts.size()) {
                out += m_parts[part].text(inLanguage);
                ++i;
            } else {
                out += sentence[i];
            }
        }
        return out;
    }

private:
    template <class... Parts>
    friend Message makeMessage(const char* sentence, const Parts&... parts);

    template <class Part>
    static Message partOf(const Part& part)
    {
        if constexpr (std::is_same_v<Part, Message>) {
            return part;
        } else if constexpr (std::is_integral_v<Part>) {
            return std::to_string(part);
        } else {
            return std::string(part);
        }
    }

    const char* m_sentence = nullptr;
    std::string m_text;
    std::vector<Message> m_parts;
};

/// @param sentence a literal
/// @param parts    whole numbers, names, and messages: what %1, %2, ... stand for
template <class... Parts>
[[nodiscard]] Message makeMessage(const char* sentence, const Parts&... parts)
{
    Message message;
    message.m_sentence = sentence;
    (message.m_parts.push_back(Message::partOf(parts)), ...);
    return message;
}

} // namespace fumage
