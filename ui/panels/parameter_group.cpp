#include "ui/panels/parameter_group.h"

#include "ui/document/key_edits.h"
#include "ui/document/parameter_text.h"
#include "ui/document/text.h"
#include "ui/panels/arrange.h"

#include "core/effect/parameter_table.h"
#include "core/effect/shown_table.h"
#include "core/effect/assignment.h"
#include "core/effect/value.h"

#include <algorithm>
#include <iterator>

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kMargin = 8;

} // namespace

ParameterGroup::ParameterGroup(
    const QString& name, const QString& label, std::vector<ParameterRow*> rows, Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_heading(new QToolButton(this))
    , m_content(new QWidget(this))
    , m_rows(std::move(rows))
    , m_scores(m_rows.size(), 0.0)
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
    m_list = new QVBoxLayout(m_content);
    m_list->setContentsMargins(kMargin, kMargin / 2, kMargin, kMargin);
    m_list->setSpacing(2);
    for (ParameterRow* row : m_rows) {
        m_list->addWidget(row);
    }
    showMark();
    connect(m_heading, &QToolButton::toggled, this, &ParameterGroup::setOpen);
    setOpen(false);
}

bool ParameterGroup::isOpen() const
{
    return m_heading->isChecked();
}

bool ParameterGroup::holdsAnyOf(const QStringList& stored) const
{
    return name() != kEssentialsName && std::any_of(m_rows.begin(), m_rows.end(), [&](const ParameterRow* row) {
        return stored.contains(toQString(row->parameter().group()));
    });
}

void ParameterGroup::setOpen(bool open)
{
    m_heading->setChecked(open);
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
        // A derived one may follow from any.
        const bool isDerived = &row->stored() != &row->parameter();
        if (isDerived || std::find(changed.begin(), changed.end(), &row->parameter()) != changed.end()) {
            row->sync();
        }
    }
    showRows();
}

void ParameterGroup::showRows()
{
    // While something is searched for, what is found is seen, folded or not.
    const bool open = isOpen() || m_isSearched || m_only.any();
    m_content->setVisible(open);
    m_heading->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows[i]->setVisible(isOfUse(i) && isWanted(i));
    }
    showMark();
}

void ParameterGroup::showMark()
{
    const bool changed =
        std::any_of(m_rows.begin(), m_rows.end(), [](const ParameterRow* row) { return row->isChanged(); });
    m_heading->setText((changed ? QStringLiteral("• ") : QString()) + m_label
        + (m_owner.isEmpty() ? QString() : QStringLiteral(" · ") + m_owner));
}

bool ParameterGroup::isOfUse(std::size_t row) const
{
    const Parameter& parameter = m_rows[row]->parameter();
    // Who searches may look for what a layer can have once it is born on another: the tip says of which it is.
    const bool hasMeaning =
        !parameter.ofBorn || m_isSearched || parentOf(m_document.scene(), m_document.layer()).has_value();
    // Key frames are in the file and in the timeline, of use or not.
    return m_only.animated || (hasMeaning && fumage::isVisible(parameter, m_document.effect()));
}

bool ParameterGroup::isWanted(std::size_t row) const
{
    const bool isInScope = !m_scope || m_rows[row]->stored().scope == *m_scope;
    return isInScope && (!m_isSearched || m_scores[row] > 0.0) && (m_rows[row]->isChanged() || !m_only.changed)
        && (m_rows[row]->isAnimated() || !m_only.animated);
}

bool ParameterGroup::has(Scope scope) const
{
    return std::any_of(
        m_rows.begin(), m_rows.end(), [&](const ParameterRow* row) { return row->stored().scope == scope; });
}

void ParameterGroup::setOwner(const QString& owner)
{
    m_owner = owner;
    showMark();
}

double ParameterGroup::filter(const std::vector<double>& scores, RowFilter only)
{
    m_isSearched = !scores.empty();
    m_scores = m_isSearched ? scores : std::vector<double>(m_rows.size(), 0.0);
    m_only = only;
    double best = 0.0;
    std::vector<std::pair<double, ParameterRow*>> ranked;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        ranked.emplace_back(m_scores[i], m_rows[i]);
        constexpr double kUnseen = 1e-3; // found, but of no use as the effect stands: it gives its group no place
        const double score = !isOfUse(i) ? kUnseen : m_isSearched ? m_scores[i] : 1.0;
        best = isWanted(i) ? std::max(best, score) : best;
    }
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<ParameterRow*> order;
    std::transform(ranked.begin(), ranked.end(), std::back_inserter(order), [](const auto& one) { return one.second; });
    arrange(*m_list, order);
    showRows();
    setVisible(best > 0.0);
    return best;
}

void ParameterGroup::copy() const
{
    QStringList lines;
    for (const ParameterRow* row : m_rows) {
        const Parameter& parameter = row->parameter();
        if (&row->stored() != &parameter) {
            continue; // what it writes has a line of its own
        }
        lines += toQString(parameter.key) + QLatin1Char('=')
            + toQString(formatText(parameter, parameter.get(m_document.effect())));
    }
    QApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

std::vector<Assignment> ParameterGroup::pasted() const
{
    std::vector<Assignment> found;
    for (const QString& line : QApplication::clipboard()->text().split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        const QString key = line.section(QLatin1Char('='), 0, 0).trimmed();
        const auto row = std::find_if(
            m_rows.begin(), m_rows.end(), [&](const ParameterRow* r) { return toQString(r->parameter().key) == key; });
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
    std::vector<const Parameter*> stored;
    for (const ParameterRow* row : m_rows) {
        stored.push_back(&row->stored());
    }
    resetParameters(m_document, stored, tr("Reset “%1”").arg(m_label));
}

void ParameterGroup::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("groupMenu"));
    menu.addAction(tr("Reset the group"), this, &ParameterGroup::reset);
    menu.addSeparator();
    menu.addAction(tr("Copy the group"), this, &ParameterGroup::copy);
    menu.addAction(tr("Paste into the group"), this, &ParameterGroup::paste)->setEnabled(!pasted().empty());
    menu.addSeparator();
    menu.addAction(tr("Expand all groups"), this, [this] { emit foldRequested(true); });
    menu.addAction(tr("Collapse all groups"), this, [this] { emit foldRequested(false); });
    menu.exec(event->globalPos());
}

} // namespace fumage::ui
