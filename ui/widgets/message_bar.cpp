#include "ui/widgets/message_bar.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace fumage::ui {

MessageBar::MessageBar(QWidget* parent)
    : QWidget(parent)
    , m_rows(new QVBoxLayout(this))
{
    setObjectName(QStringLiteral("messageBar"));
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setSpacing(0);
    hide();
}

QWidget* MessageBar::find(const QString& name) const
{
    return findChild<QWidget*>(name, Qt::FindDirectChildrenOnly);
}

void MessageBar::say(const QString& name, const QString& text, const std::vector<Answer>& answers)
{
    take(name);
    auto* row = new QFrame(this);
    row->setObjectName(name);
    row->setProperty("role", QStringLiteral("message"));
    auto* label = new QLabel(text, row);
    label->setObjectName(name + QStringLiteral(".text"));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(12, 6, 12, 6);
    layout->addWidget(label, 1);
    for (std::size_t i = 0; i < answers.size(); ++i) {
        auto* button = new QPushButton(answers[i].text, row);
        button->setObjectName(QStringLiteral("%1.%2").arg(name).arg(i));
        layout->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, name, act = answers[i].act] {
            take(name);
            if (act) {
                act();
            }
        });
    }
    m_rows->addWidget(row);
    followRows();
    QAccessibleEvent heard(label, QAccessible::Alert);
    QAccessible::updateAccessibility(&heard);
}

void MessageBar::take(const QString& name)
{
    if (QWidget* row = find(name)) {
        row->setObjectName(QString()); // it is no more, and lives on until its button has been let go
        row->hide();
        row->deleteLater();
        m_rows->removeWidget(row);
        followRows();
    }
}

void MessageBar::setAllHidden(bool away)
{
    m_isAway = away;
    followRows();
}

void MessageBar::followRows()
{
    setVisible(m_rows->count() > 0 && !m_isAway);
}

} // namespace fumage::ui
