#pragma once

#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

class QVBoxLayout;

namespace fumage::ui {

/// Messages that stay until they are answered or no longer true, above what they speak of. Nothing is waited for
/// meanwhile.
class MessageBar : public QWidget {
    Q_OBJECT

public:
    struct Answer {
        QString text;
        std::function<void()> act; ///< empty: the message goes, and that is all
    };

    explicit MessageBar(QWidget* parent = nullptr);

    /// Shows a message as it is, in place of another of its name.
    /// @param name    objectName of its row; those of its buttons are name.0, name.1...
    /// @param answers on buttons; any of them takes the message away
    void say(const QString& name, const QString& text, const std::vector<Answer>& answers);
    void take(const QString& name);
    /// Whether nobody is to see it for now; messages stay.
    void setAllHidden(bool away);
    [[nodiscard]] bool says(const QString& name) const { return find(name) != nullptr; }

private:
    [[nodiscard]] QWidget* find(const QString& name) const;
    void followRows();

    QVBoxLayout* m_rows;
    bool m_isAway = false;
};

} // namespace fumage::ui
