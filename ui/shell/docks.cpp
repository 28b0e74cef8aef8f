#include "ui/shell/docks.h"

#include "ui/export/queue_panel.h"
#include "ui/noise_preview/noise_pane.h"
#include "ui/panels/effect_panel.h"
#include "ui/panels/parameter_rows.h"
#include "ui/presets/preset_browser.h"
#include "ui/presets/variations_panel.h"
#include "ui/shell/history_view.h"
#include "ui/widgets/vertical_scroll_area.h"

#include "core/effect/known_parameter.h"

#include <algorithm>
#include <utility>

#include <QMainWindow>
#include <QMenu>

namespace fumage::ui {

namespace {

/// A panel that may be lower than what is in it: on a small screen it would push the window beyond the edge.
VerticalScrollArea* lowPanel(QWidget* content)
{
    auto* panel = new VerticalScrollArea;
    panel->setObjectName(content->objectName() + QStringLiteral(".scroll"));
    panel->setWidget(content);
    return panel;
}

void bringToFront(QDockWidget& dock)
{
    dock.show();
    dock.raise();
}

} // namespace

Docks::Docks(QMainWindow& window, Document& document, Locks& locks, Solo& solo, ExportQueue& exports,
    const AskForFile& askForFile)
    : m_window(window)
    , m_exports(exports)
    , m_browser(new PresetBrowser)
    , m_effectPanel(new EffectPanel(document, locks, solo))
    , m_noisePane(new NoisePane(document))
    , m_queuePanel(new QueuePanel(exports, askForFile))
    , m_presets(makeDock(QStringLiteral("dock.presets"), tr("Presets"), m_browser))
    , m_parameters(makeDock(QStringLiteral("dock.parameters"), tr("Parameters"), m_effectPanel))
    , m_noise(makeDock(QStringLiteral("dock.noise"), tr("Noise"), lowPanel(m_noisePane)))
    , m_history(makeDock(QStringLiteral("dock.history"), tr("History"), new HistoryView(document.undoStack())))
    , m_variations(
          makeDock(QStringLiteral("dock.variations"), tr("Variations"), lowPanel(new VariationsPanel(document, locks))))
    , m_queue(makeDock(QStringLiteral("dock.queue"), tr("Exports"), m_queuePanel))
{
    constexpr std::array kBesideTheNoise{&knownParameter("noise.octaves"), &knownParameter("noise.sharpness")};
    m_noisePane->addControls(new ParameterRows(kBesideTheNoise, QStringLiteral("noisePane/"), document, locks));
    arrange();
}

std::array<QDockWidget*, 6> Docks::all() const
{
    return {m_presets.get(), m_noise.get(), m_history.get(), m_variations.get(), m_parameters.get(), m_queue.get()};
}

Docks::Dock Docks::makeDock(const QString& name, const QString& title, QWidget* content)
{
    auto dock = std::make_unique<QDockWidget>(title, &m_window);
    dock->setObjectName(name);
    dock->setWidget(content);
    // The tab of a tabbed panel says its name: a bar with the same name below it would say it twice.
    const auto followTabs = [this, dock = dock.get()] {
        const bool tabbed = !dock->isFloating() && !m_window.tabifiedDockWidgets(dock).isEmpty();
        if (tabbed != (dock->titleBarWidget() != nullptr)) {
            const std::unique_ptr<QWidget> old(dock->titleBarWidget());
            dock->setTitleBarWidget(tabbed ? new QWidget(dock) : nullptr);
        }
    };
    connect(dock.get(), &QDockWidget::visibilityChanged, dock.get(), followTabs, Qt::QueuedConnection);
    connect(dock.get(), &QDockWidget::topLevelChanged, dock.get(), followTabs, Qt::QueuedConnection);
    connect(dock.get(), &QDockWidget::dockLocationChanged, dock.get(), followTabs, Qt::QueuedConnection);
    return dock;
}

void Docks::arrange()
{
    for (QDockWidget* dock : all()) {
        dock->setFloating(false);
        dock->setVisible(dock != m_queue.get() || m_exports.rowCount() > 0);
    }
    m_window.addDockWidget(Qt::LeftDockWidgetArea, m_presets.get());
    m_window.addDockWidget(Qt::LeftDockWidgetArea, m_noise.get());
    // Where there is no room for two, one lies behind the other.
    constexpr int kMinForBoth = 820;
    const bool both = m_window.height() >= kMinForBoth;
    if (both) {
        m_window.splitDockWidget(m_presets.get(), m_noise.get(), Qt::Vertical);
    } else {
        m_window.tabifyDockWidget(m_presets.get(), m_noise.get());
        m_presets->raise();
    }
    m_window.tabifyDockWidget(m_presets.get(), m_queue.get());
    m_presets->raise();
    m_window.addDockWidget(Qt::RightDockWidgetArea, m_parameters.get());
    m_window.tabifyDockWidget(m_parameters.get(), m_variations.get());
    m_window.tabifyDockWidget(m_variations.get(), m_history.get());
    m_parameters->raise();
    constexpr int kLeft = 316;
    constexpr int kRight = 376;
    m_window.resizeDocks({m_presets.get(), m_parameters.get()}, {kLeft, kRight}, Qt::Horizontal);
    if (both) {
        constexpr int kNoise = 470;
        m_window.resizeDocks({m_presets.get(), m_noise.get()}, {m_window.height() - kNoise, kNoise}, Qt::Vertical);
    }
}

void Docks::setAllHidden(bool away)
{
    if (away == !m_before.isEmpty()) {
        return;
    }
    if (!away) {
        m_window.restoreState(std::exchange(m_before, {}));
        return;
    }
    m_before = m_window.saveState();
    for (QDockWidget* dock : all()) {
        dock->hide();
    }
}

void Docks::showVariations()
{
    bringToFront(*m_variations);
}

void Docks::showQueue()
{
    bringToFront(*m_queue);
}

void Docks::addQueue()
{
    const QList<QDockWidget*> beside = m_window.tabifiedDockWidgets(m_queue.get());
    m_queue->show();
    // A dock that is shown comes to the front of its tabs.
    for (QDockWidget* dock : beside) {
        if (dock == m_presets.get()) {
            dock->raise();
        }
    }
}

void Docks::searchParameters()
{
    bringToFront(*m_parameters);
    m_effectPanel->search();
}

void Docks::showParameter(const QString& key)
{
    bringToFront(*m_parameters);
    m_effectPanel->showParameter(key);
}

void Docks::fillMenu(QMenu& menu) const
{
    for (const QDockWidget* dock : all()) {
        menu.addAction(dock->toggleViewAction());
    }
}

} // namespace fumage::ui
