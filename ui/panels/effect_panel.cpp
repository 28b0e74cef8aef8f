#include "ui/panels/effect_panel.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"

#include "core/effect/known_parameter.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"

#include <algorithm>
#include <array>

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kMargin = 8;
const QString kEssentialsName = QStringLiteral("essentials");

/// What an artist needs first, once more above all groups.
constexpr std::array kEssentials{
    &knownParameter("look.opacity"),
    &knownParameter("look.size"),
    &knownParameter("look.colour"),
    &knownParameter("life.fade_rate"),
    &knownParameter("emitter.normal"),
    &knownParameter("motion.wind_angle"),
    &knownParameter("motion.gravity"),
    &knownParameter("noise.octaves"),
    &knownParameter("noise.sharpness"),
    &knownParameter("timeline.loop"),
};

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

ParameterGroup::ParameterGroup(const QString& name, const QString& label, std::vector<ParameterRow*> rows, Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_heading(new QToolButton(this))
    , m_content(new QWidget(this))
    , m_rows(std::move(rows))
    , m_label(label)
{
    setObjectName(QStringLiteral("group.") + name);
    m_heading->setObjectName(objectName() + QStringLiteral(".heading"));
    m_heading->setProperty("role", QStringLiteral("heading"));
    m_heading->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_heading->setCheckable(true);
    m_heading->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_heading);
    layout->addWidget(m_content);
    auto* list = new QVBoxLayout(m_content);
    list->setContentsMargins(kMargin, kMargin / 2, kMargin, kMargin);
    list->setSpacing(2);
    for (ParameterRow* row : m_rows) {
        list->addWidget(row);
    }
    showMark();
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
    m_content->setVisible(isOpen() || !m_words.isEmpty() || m_onlyChanged);
    for (ParameterRow* row : m_rows) {
        row->setVisible(fumage::isVisible(row->parameter(), m_document.effect()) && isWanted(*row));
    }
    showMark();
}

void ParameterGroup::showMark()
{
    const bool changed = std::any_of(m_rows.begin(), m_rows.end(), [](const ParameterRow* row) { return row->isChanged(); });
    m_heading->setText((changed ? QStringLiteral("• ") : QString()) + m_label);
}

bool ParameterGroup::isWanted(const ParameterRow& row) const
{
    return row.matches(m_words) && (row.isChanged() || !m_onlyChanged);
}

bool ParameterGroup::filter(const QStringList& words, bool onlyChanged)
{
    m_words = words;
    m_onlyChanged = onlyChanged;
    showRows();
    const bool any = std::any_of(m_rows.begin(), m_rows.end(), [this](const ParameterRow* row) { return isWanted(*row); });
    setVisible(any);
    return any;
}

void ParameterGroup::copy() const
{
    QStringList lines;
    for (const ParameterRow* row : m_rows) {
        const Parameter& parameter = row->parameter();
        lines += toQString(parameter.key) + QLatin1Char('=') + toQString(formatText(parameter, parameter.get(m_document.effect())));
    }
    QApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

std::vector<Assignment> ParameterGroup::pasted() const
{
    std::vector<Assignment> found;
    for (const QString& line : QApplication::clipboard()->text().split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        const QString key = line.section(QLatin1Char('='), 0, 0).trimmed();
        const auto row = std::find_if(m_rows.begin(), m_rows.end(), [&](const ParameterRow* r) { return toQString(r->parameter().key) == key; });
        if (row == m_rows.end()) {
            continue;
        }
        Effect read = m_document.effect();
        if (applyAssignment(read, line.trimmed().toStdString())) {
            found.push_back({&(*row)->parameter(), (*row)->parameter().get(read)});
        }
    }
    return found;
}

void ParameterGroup::paste()
{
    m_document.edit(pasted(), tr("Paste into “%1”").arg(m_label));
}

void ParameterGroup::reset()
{
    std::vector<Assignment> before;
    for (const ParameterRow* row : m_rows) {
        before.push_back({&row->parameter(), row->parameter().get(m_document.reference())});
    }
    m_document.edit(before, tr("Reset “%1”").arg(m_label));
}

void ParameterGroup::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("groupMenu"));
    menu.addAction(tr("Reset the group"), this, &ParameterGroup::reset);
    menu.addSeparator();
    menu.addAction(tr("Copy the group"), this, &ParameterGroup::copy);
    menu.addAction(tr("Paste into the group"), this, &ParameterGroup::paste)->setEnabled(!pasted().empty());
    menu.exec(event->globalPos());
}

EffectPanel::EffectPanel(Document& document, Locks& locks, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_search(new QLineEdit(this))
    , m_onlyChanged(new QToolButton(this))
    , m_nothing(new QLabel(this))
    , m_scroll(new QScrollArea(this))
{
    setObjectName(QStringLiteral("effectPanel"));
    m_search->setObjectName(QStringLiteral("parameterSearch"));
    m_search->setAccessibleName(tr("Search parameters"));
    m_search->setPlaceholderText(tr("Search parameters"));
    m_search->setClearButtonEnabled(true);
    m_onlyChanged->setObjectName(QStringLiteral("onlyChanged"));
    m_onlyChanged->setText(QStringLiteral("•"));
    m_onlyChanged->setCheckable(true);
    m_onlyChanged->setToolTip(tr("Only the parameters that differ from the preset"));
    m_onlyChanged->setAccessibleName(m_onlyChanged->toolTip());
    m_nothing->setObjectName(QStringLiteral("parameterSearch.nothing"));
    m_nothing->setProperty("role", QStringLiteral("secondary"));
    m_nothing->setWordWrap(true);
    m_nothing->hide();
    m_scroll->setWidget(makeGroups(locks));
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFrameShape(QFrame::NoFrame);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* top = new QVBoxLayout;
    top->setContentsMargins(kMargin, kMargin, kMargin, 0);
    auto* bar = new QHBoxLayout;
    bar->addWidget(m_search, 1);
    bar->addWidget(m_onlyChanged);
    top->addLayout(bar);
    top->addWidget(m_nothing);
    layout->addLayout(top);
    layout->addWidget(m_scroll, 1);
    connect(m_search, &QLineEdit::textChanged, this, &EffectPanel::filter);
    connect(m_onlyChanged, &QToolButton::toggled, this, &EffectPanel::filter);
    connect(&document, &Document::effectChanged, this, &EffectPanel::follow);
    connect(&document, &Document::titleChanged, this, &EffectPanel::sync);
    sync();
    setOpenGroups(usualGroups());
}

QStringList EffectPanel::usualGroups()
{
    return {kEssentialsName, QStringLiteral("emitter"), QStringLiteral("motion")};
}

QWidget* EffectPanel::makeGroups(Locks& locks)
{
    auto* content = new QWidget(m_scroll);
    auto* list = new QVBoxLayout(content);
    list->setContentsMargins(0, 0, 0, 0);
    list->setSpacing(1);
    const auto add = [&](const QString& name, const QString& label, std::vector<ParameterRow*> rows) {
        m_groups.push_back(new ParameterGroup(name, label, std::move(rows), m_document, content));
        list->addWidget(m_groups.back());
    };
    std::vector<ParameterRow*> essentials;
    for (const Parameter* parameter : kEssentials) {
        essentials.push_back(new ParameterRow(*parameter, m_document, locks, content));
        essentials.back()->prefixNames(kEssentialsName + QLatin1Char('/'));
    }
    add(kEssentialsName, tr("Essentials"), std::move(essentials));
    for (const std::string_view group : groups()) {
        std::vector<ParameterRow*> rows;
        for (const Parameter& parameter : parameterTable()) {
            if (parameter.group() == group) {
                rows.push_back(new ParameterRow(parameter, m_document, locks, content));
            }
        }
        add(toQString(group), groupLabelOf(group), std::move(rows));
    }
    list->addStretch();
    return content;
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
    if (m_onlyChanged->isChecked()) {
        filter();
    }
}

void EffectPanel::filter()
{
    const QString text = m_search->text();
    const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    const bool onlyChanged = m_onlyChanged->isChecked();
    bool any = false;
    for (ParameterGroup* group : m_groups) {
        any = group->filter(words, onlyChanged) || any;
    }
    // What stands there once more is not to be found twice.
    m_groups.front()->setVisible(words.isEmpty() && !onlyChanged);
    m_nothing->setVisible(!any);
    m_nothing->setText(words.isEmpty() ? tr("Nothing differs from the preset.") : tr("No parameter is found by “%1”. Try a part of a word, or another word.").arg(text));
}

void EffectPanel::showGroup(std::string_view name)
{
    auto* group = findChild<ParameterGroup*>(QStringLiteral("group.") + toQString(name));
    if (group != nullptr) {
        m_search->clear();
        m_onlyChanged->setChecked(false);
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
