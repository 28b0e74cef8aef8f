#include "ui/panels/effect_panel.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"

#include "core/effect/parameter_table.h"

#include <algorithm>

#include <QLineEdit>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kMargin = 8;

std::vector<std::string_view> groups()
{
    std::vector<std::string_view> names;
    for (const Parameter& parameter : parameterTable()) {
        if (std::find(names.begin(), names.end(), parameter.group()) == names.end()) {
            names.push_back(parameter.group());
        }
    }
    return names;
}

} // namespace

ParameterGroup::ParameterGroup(std::string_view group, Document& document, Locks& locks, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_heading(new QToolButton(this))
    , m_content(new QWidget(this))
{
    setObjectName(QStringLiteral("group.") + toQString(group));
    m_heading->setObjectName(objectName() + QStringLiteral(".heading"));
    m_heading->setProperty("role", QStringLiteral("heading"));
    m_heading->setText(groupLabelOf(group));
    m_heading->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_heading->setCheckable(true);
    m_heading->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_heading);
    layout->addWidget(m_content);
    auto* rows = new QVBoxLayout(m_content);
    rows->setContentsMargins(kMargin, kMargin / 2, kMargin, kMargin);
    rows->setSpacing(2);
    for (const Parameter& parameter : parameterTable()) {
        if (parameter.group() == group) {
            m_rows.push_back(new ParameterRow(parameter, document, locks, m_content));
            rows->addWidget(m_rows.back());
        }
    }
    connect(m_heading, &QToolButton::toggled, this, &ParameterGroup::setOpen);
    setOpen(false);
}

bool ParameterGroup::isOpen() const
{
    return m_heading->isChecked();
}

void ParameterGroup::setOpen(bool open)
{
    m_heading->setChecked(open);
    m_heading->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    showRows();
}

void ParameterGroup::sync()
{
    for (ParameterRow* row : m_rows) {
        row->sync();
    }
    showRows();
}

void ParameterGroup::sync(const std::vector<const Parameter*>& changed)
{
    for (ParameterRow* row : m_rows) {
        if (std::find(changed.begin(), changed.end(), &row->parameter()) != changed.end()) {
            row->sync();
        }
    }
    showRows();
}

void ParameterGroup::showRows()
{
    // While something is searched for, what is found is seen, folded or not.
    m_content->setVisible(isOpen() || !m_words.isEmpty());
    for (ParameterRow* row : m_rows) {
        row->setVisible(fumage::isVisible(row->parameter(), m_document.effect()) && row->matches(m_words));
    }
}

bool ParameterGroup::filter(const QStringList& words)
{
    m_words = words;
    showRows();
    const bool any = std::any_of(m_rows.begin(), m_rows.end(), [&](const ParameterRow* row) { return row->matches(words); });
    setVisible(any);
    return any;
}

EffectPanel::EffectPanel(Document& document, Locks& locks, QWidget* parent)
    : QWidget(parent)
    , m_search(new QLineEdit(this))
    , m_scroll(new QScrollArea(this))
{
    setObjectName(QStringLiteral("effectPanel"));
    m_search->setObjectName(QStringLiteral("parameterSearch"));
    m_search->setAccessibleName(tr("Search parameters"));
    m_search->setPlaceholderText(tr("Search parameters"));
    m_search->setClearButtonEnabled(true);
    auto* content = new QWidget(m_scroll);
    auto* list = new QVBoxLayout(content);
    list->setContentsMargins(0, 0, 0, 0);
    list->setSpacing(1);
    for (const std::string_view group : groups()) {
        m_groups.push_back(new ParameterGroup(group, document, locks, content));
        list->addWidget(m_groups.back());
    }
    list->addStretch();
    m_scroll->setWidget(content);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFrameShape(QFrame::NoFrame);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* top = new QVBoxLayout;
    top->setContentsMargins(kMargin, kMargin, kMargin, 0);
    top->addWidget(m_search);
    layout->addLayout(top);
    layout->addWidget(m_scroll, 1);
    connect(m_search, &QLineEdit::textChanged, this, &EffectPanel::filter);
    connect(&document, &Document::effectChanged, this, &EffectPanel::follow);
    connect(&document, &Document::titleChanged, this, &EffectPanel::sync);
    sync();
    setOpenGroups({QStringLiteral("emitter"), QStringLiteral("motion")});
}

void EffectPanel::sync()
{
    for (ParameterGroup* group : m_groups) {
        group->sync();
    }
}

void EffectPanel::follow(const EffectChange& change)
{
    for (ParameterGroup* group : m_groups) {
        group->sync(change.parameters);
    }
}

void EffectPanel::filter(const QString& text)
{
    const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (ParameterGroup* group : m_groups) {
        group->filter(words);
    }
}

void EffectPanel::showGroup(std::string_view name)
{
    auto* group = findChild<ParameterGroup*>(QStringLiteral("group.") + toQString(name));
    if (group != nullptr) {
        m_search->clear();
        group->setOpen(true);
        // The layout has to know how tall the group is now before the bar can go there.
        m_scroll->widget()->layout()->activate();
        m_scroll->verticalScrollBar()->setValue(group->y());
    }
}

void EffectPanel::showParameter(const QString& key)
{
    auto* editor = findChild<ParameterEditor*>(key);
    if (editor == nullptr) {
        return;
    }
    showGroup(editor->parameter().group());
    m_scroll->ensureWidgetVisible(editor);
    editor->setFocus(Qt::ShortcutFocusReason);
}

void EffectPanel::search()
{
    m_search->setFocus(Qt::ShortcutFocusReason);
    m_search->selectAll();
}

QStringList EffectPanel::openGroups() const
{
    QStringList names;
    for (const ParameterGroup* group : m_groups) {
        if (group->isOpen()) {
            names += group->objectName().mid(QStringLiteral("group.").size());
        }
    }
    return names;
}

void EffectPanel::setOpenGroups(const QStringList& names)
{
    for (ParameterGroup* group : m_groups) {
        group->setOpen(names.contains(group->objectName().mid(QStringLiteral("group.").size())));
    }
}

} // namespace fumage::ui
