#include "ui/panels/effect_panel.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"
#include "ui/panels/arrange.h"
#include "ui/panels/layer_list.h"
#include "ui/widgets/plain_text.h"
#include "ui/widgets/vertical_scroll_area.h"

#include "core/effect/known_parameter.h"
#include "core/effect/parameter_table.h"
#include "core/effect/shown_table.h"
#include "core/effect/value.h"

#include <algorithm>
#include <array>
#include <iterator>

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kMargin = 8;
const QString kClosed = QStringLiteral("-"); ///< before the name of a group that is folded

/// What an artist needs first, once more above all groups.
/// In their order.
std::vector<const Parameter*> essentialParameters()
{
    std::vector<const Parameter*> essentials;
    for (const Parameter& parameter : parameterTable()) {
        if (parameter.essential > 0) {
            essentials.push_back(&parameter);
        }
    }
    std::sort(essentials.begin(), essentials.end(),
        [](const Parameter* a, const Parameter* b) { return a->essential < b->essential; });
    return essentials;
}

/// A button beside the search that leaves rows out.
QToolButton* makeFilterButton(QWidget* parent, const QString& name, const QString& sign)
{
    auto* button = new QToolButton(parent);
    button->setObjectName(name);
    button->setText(sign);
    button->setCheckable(true);
    return button;
}

} // namespace

EffectPanel::EffectPanel(Document& document, Locks& locks, Solo& solo, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_layers(new LayerList(document, solo, this))
    , m_tabs(new QTabBar(this))
    , m_search(new QLineEdit(this))
    , m_onlyChanged(makeFilterButton(this, QStringLiteral("onlyChanged"), QStringLiteral("•")))
    , m_onlyAnimated(makeFilterButton(this, QStringLiteral("onlyAnimated"), QStringLiteral("◆")))
    , m_nothing(new QLabel(this))
    , m_scroll(new VerticalScrollArea(this))
{
    setObjectName(QStringLiteral("effectPanel"));
    m_search->setObjectName(QStringLiteral("parameterSearch"));
    m_search->setAccessibleName(tr("Search parameters"));
    m_search->setPlaceholderText(tr("Search parameters"));
    m_search->setClearButtonEnabled(true);
    m_onlyChanged->setToolTip(tr("Only the parameters that differ from the preset"));
    m_onlyChanged->setAccessibleName(m_onlyChanged->toolTip());
    m_onlyAnimated->setToolTip(tr("Only the parameters that have key frames"));
    m_onlyAnimated->setAccessibleName(m_onlyAnimated->toolTip());
    m_nothing->setObjectName(QStringLiteral("parameterSearch.nothing"));
    m_nothing->setProperty("role", QStringLiteral("secondary"));
    m_nothing->setWordWrap(true);
    m_nothing->hide();
    m_scroll->setWidget(makeGroups(locks));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* top = new QVBoxLayout;
    top->setContentsMargins(kMargin, kMargin, kMargin, 0);
    auto* bar = new QHBoxLayout;
    bar->addWidget(m_search, 1);
    bar->addWidget(m_onlyChanged);
    bar->addWidget(m_onlyAnimated);
    top->addLayout(bar);
    top->addWidget(m_nothing);
    makeTabs();
    top->addWidget(m_tabs);
    layout->addWidget(m_layers);
    layout->addLayout(top);
    layout->addWidget(m_scroll, 1);
    connect(m_search, &QLineEdit::textChanged, this, &EffectPanel::filter);
    connect(m_onlyChanged, &QToolButton::toggled, this, &EffectPanel::filter);
    connect(m_onlyAnimated, &QToolButton::toggled, this, &EffectPanel::filter);
    connect(&document, &Document::effectChanged, this, &EffectPanel::follow);
    connect(&document, &Document::selectionChanged, this, &EffectPanel::followLayers);
    connect(&document, &Document::titleChanged, this, &EffectPanel::sync);
    sync();
    setOpenGroups(usualGroups());
    followLayers();
}

void EffectPanel::makeTabs()
{
    m_tabs->setObjectName(QStringLiteral("parameterTabs"));
    m_tabs->setAccessibleName(tr("Parameters of"));
    m_tabs->addTab({});
    m_tabs->addTab(tr("Scene"));
    m_tabs->setExpanding(true);
    m_tabs->setElideMode(Qt::ElideRight);
    m_tabs->setDrawBase(false);
    m_tabs->hide();
    connect(m_tabs, &QTabBar::currentChanged, this, &EffectPanel::filter);
}

QStringList EffectPanel::usualGroups()
{
    return {kEssentialsName, QStringLiteral("emitter"), QStringLiteral("motion")};
}

QWidget* EffectPanel::makeGroups(Locks& locks)
{
    auto* content = new QWidget(m_scroll);
    m_list = new QVBoxLayout(content);
    m_list->setContentsMargins(0, 0, 0, 0);
    m_list->setSpacing(1);
    const auto add = [&](const QString& name, const QString& label, std::vector<ParameterRow*> rows) {
        auto* group = new ParameterGroup(name, label, std::move(rows), m_document, content);
        m_groups.push_back(group);
        m_list->addWidget(group);
        connect(group, &ParameterGroup::foldRequested, this, &EffectPanel::foldAll);
    };
    std::vector<ParameterRow*> essentials;
    for (const Parameter* parameter : essentialParameters()) {
        essentials.push_back(new ParameterRow(*parameter, m_document, locks, content));
        essentials.back()->prefixNames(kEssentialsName + QLatin1Char('/'));
    }
    add(kEssentialsName, tr("Essentials"), std::move(essentials));
    const std::vector<const Parameter*>& all = shownParameters();
    for (auto first = all.begin(); first != all.end();) {
        const std::string_view group = (*first)->group();
        std::vector<ParameterRow*> rows;
        for (; first != all.end() && (*first)->group() == group; ++first) {
            rows.push_back(new ParameterRow(**first, m_document, locks, content));
            m_index.add(searchTextsOf(**first));
        }
        add(toQString(group), groupLabelOf(group), std::move(rows));
    }
    m_list->addStretch();
    return content;
}

void EffectPanel::foldAll(bool open)
{
    for (ParameterGroup* group : m_groups) {
        group->setOpen(open);
    }
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
    if (only().any()) {
        filter();
    }
}

void EffectPanel::followLayers()
{
    const bool hasTabs = m_document.scene().layers.size() > 1;
    m_tabs->setTabText(0, hasTabs ? plainMenuText(layerLabel(m_document.scene(), m_document.layer())) : QString());
    if (hasTabs != m_hasTabs || m_tabs->isHidden()) {
        m_hasTabs = hasTabs;
        filter();
    }
}

std::optional<Scope> EffectPanel::shownScope() const
{
    return m_tabs->isHidden() ? std::nullopt : std::optional(m_tabs->currentIndex() == 0 ? Scope::Layer : Scope::Scene);
}

void EffectPanel::filter()
{
    const QString text = m_search->text();
    const bool isSearched = !text.trimmed().isEmpty();
    const bool isWhole = !isSearched && !only().any();
    // A search and a list of changes are of both, and say which is which.
    m_tabs->setVisible(m_hasTabs && isWhole);
    for (ParameterGroup* group : m_groups) {
        group->setScope(shownScope());
        const QString owner = group->has(Scope::Scene) ? tr("Scene") : m_tabs->tabText(0);
        group->setOwner(m_hasTabs && m_tabs->isHidden() ? owner : QString());
    }
    const std::vector<double> scores = isSearched ? m_index.scores(text) : std::vector<double>();
    auto next = scores.begin();
    std::vector<std::pair<double, ParameterGroup*>> ranked;
    for (ParameterGroup* group : m_groups) {
        std::vector<double> part;
        if (isSearched && group != m_groups.front()) { // what stands in the first once more is not to be found twice
            part.assign(next, next + static_cast<std::ptrdiff_t>(group->size()));
            next += static_cast<std::ptrdiff_t>(group->size());
        }
        ranked.emplace_back(group->filter(part, only()), group);
    }
    m_groups.front()->setVisible(isWhole && ranked.front().first > 0.0);
    const bool any = std::any_of(ranked.begin() + 1, ranked.end(), [](const auto& one) { return one.first > 0.0; });
    if (isSearched) { // the best on top
        std::stable_sort(
            ranked.begin() + 1, ranked.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    }
    std::vector<ParameterGroup*> order;
    std::transform(ranked.begin(), ranked.end(), std::back_inserter(order), [](const auto& one) { return one.second; });
    arrange(*m_list, order);
    m_nothing->setVisible(!any);
    m_nothing->setText(nothingText());
}

RowFilter EffectPanel::only() const
{
    return {m_onlyChanged->isChecked(), m_onlyAnimated->isChecked()};
}

QString EffectPanel::nothingText() const
{
    const bool isAnyAnimated = !m_document.scene().allTracks(m_document.layer()).all().empty();
    if (only().animated && !isAnyAnimated) {
        return tr("Nothing has key frames: the diamond beside a parameter sets one.");
    }
    if (!m_search->text().trimmed().isEmpty()) {
        return tr("No parameter matches “%1”. Try a part of a word, or another word.").arg(m_search->text());
    }
    return only().animated && only().changed ? tr("Nothing that has key frames differs from the preset.")
                                             : tr("Nothing differs from the preset.");
}

void EffectPanel::showGroup(std::string_view name)
{
    auto* group = findChild<ParameterGroup*>(QStringLiteral("group.") + toQString(name));
    if (group != nullptr) {
        m_search->clear();
        m_onlyChanged->setChecked(false);
        m_onlyAnimated->setChecked(false);
        m_tabs->setCurrentIndex(group->has(Scope::Layer) ? 0 : 1);
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
        names += group->isOpen() ? group->name() : kClosed + group->name();
    }
    return names;
}

void EffectPanel::setOpenGroups(const QStringList& names)
{
    for (ParameterGroup* group : m_groups) {
        // Who names groups by what is stored means all that is shown of it.
        const bool isMeant = !names.contains(kClosed + group->name()) && group->holdsAnyOf(names);
        group->setOpen(names.contains(group->name()) || isMeant);
    }
}

} // namespace fumage::ui
