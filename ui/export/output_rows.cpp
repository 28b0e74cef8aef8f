#include "ui/export/output_rows.h"

#include "ui/panels/parameter_row.h"

#include "core/effect/known_parameter.h"
#include "core/effect/parameter_table.h"

#include <QCoreApplication>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr const Parameter& kWidth = knownParameter("output.width");
constexpr const Parameter& kHeight = knownParameter("output.height");
constexpr const Parameter& kBackground = knownParameter("output.background");
constexpr const Parameter& kColour = knownParameter("output.background_colour");

} // namespace

OutputRows::OutputRows(Document& document, Locks& locks, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
{
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins({});
    for (const Parameter& parameter : parameterTable()) {
        if (parameter.atExport) {
            m_rows.push_back(new ParameterRow(parameter, document, locks, this));
            box->addWidget(m_rows.back());
        }
    }
}

bool OutputRows::isAsked(const Parameter& parameter, const ExportPlan& plan) const
{
    const bool asked = fumage::isVisible(parameter, m_document.effect());
    // What has no transparency is on the colour, whatever the background is.
    const bool onColour = plan.kind == ExportKind::Video && !hasAlpha(plan.video.format);
    return &parameter == &kColour ? asked || onColour : asked && !(onColour && &parameter == &kBackground);
}

void OutputRows::follow(const ExportPlan& plan)
{
    const bool isFlipbook = plan.kind == ExportKind::Flipbook;
    for (ParameterRow* row : m_rows) {
        row->sync();
        row->setVisible(isAsked(row->parameter(), plan));
        if (&row->parameter() == &kWidth) {
            row->setName(isFlipbook ? QCoreApplication::translate("Exports", "Cell width") : QString());
        } else if (&row->parameter() == &kHeight) {
            row->setName(isFlipbook ? QCoreApplication::translate("Exports", "Cell height") : QString());
        }
    }
    setVisible(isPicture(plan.kind));
}

} // namespace fumage::ui
