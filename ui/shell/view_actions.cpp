#include "ui/shell/view_actions.h"

#include "ui/panels/colour_editor.h"
#include "ui/shell/action_table.h"
#include "ui/viewport/viewport.h"

#include <QClipboard>
#include <QColorDialog>
#include <QEvent>
#include <QGuiApplication>
#include <QMenu>
#include <QWidget>

namespace fumage::ui {

namespace {

struct OverlayAction {
    const char* action;
    Overlay overlay;
    bool remembered = true;
};
constexpr OverlayAction kOverlayActions[] = {
    {"view.grid", Overlay::Grid},
    {"view.emitter", Overlay::Emitter},
    {"view.gizmos", Overlay::Gizmos},
    {"view.trails", Overlay::Trails},
    {"view.air", Overlay::Air},
    {.action = "view.frame", .overlay = Overlay::Frame, .remembered = false}, // comes and goes with the export dialog
    {"view.readout", Overlay::Readout},
};

/// Of the smoke, as stray sparks have it.
constexpr float kOutlierPercent = 1.0F;

/// A view from a side; straight up and down would leave no horizon.
struct Side {
    const char* action;
    float yaw;
    float pitch;
};
constexpr Side kSides[] = {
    {"view.front", 0.0F, 0.0F},
    {"view.right", 90.0F, 0.0F},
    {"view.back", 180.0F, 0.0F},
    {"view.left", -90.0F, 0.0F},
    {"view.top", 0.0F, 89.0F},
    {"view.bottom", 0.0F, -89.0F},
};

} // namespace

ViewActions::ViewActions(const ActionSet& actions, Document& document, Viewport& viewport, QWidget& window)
    : m_actions(actions)
    , m_viewport(viewport)
    , m_window(window)
    , m_fit(document, viewport.shelf())
{
    m_actions.on("view.frameAll", &m_viewport, &Viewport::frameAll);
    m_actions.on("view.frameAnimation", &m_fit, [this] { m_fit.start(); });
    m_actions.on("view.frameWithoutOutliers", &m_fit, [this] { m_fit.start(kOutlierPercent); });
    for (const Side& side : kSides) {
        m_actions.on(side.action, this, [this, side] { m_viewport.lookFrom(side.yaw, side.pitch); });
    }
    m_actions.on("view.resetCamera", &m_viewport, &Viewport::resetCamera);
    m_actions.on("view.copyFrame", this, [this] { QGuiApplication::clipboard()->setImage(m_viewport.shownPicture()); });
    connect(&m_viewport, &Viewport::menuRequested, this, &ViewActions::showMenu);
    connectOverlays();
    connectBackdrop();
    connectFullScreen();
}

void ViewActions::connectOverlays()
{
    for (const OverlayAction& entry : kOverlayActions) {
        QAction& action = m_actions.get(entry.action);
        action.setChecked(m_viewport.overlays().testFlag(entry.overlay));
        connect(&action, &QAction::toggled, this,
            [this, overlay = entry.overlay](bool on) { m_viewport.setOverlay(overlay, on); });
    }
}

void ViewActions::connectBackdrop()
{
    QAction& checker = m_actions.get("view.checker");
    connect(&checker, &QAction::toggled, this, [this](bool on) {
        Backdrop backdrop = m_viewport.backdrop();
        backdrop.kind = on ? Backdrop::Kind::Checker : Backdrop::Kind::Colour;
        m_viewport.setBackdrop(backdrop);
    });
    m_actions.on("view.backdrop", this, [this, &checker] {
        const bool wasChecked = checker.isChecked();
        const QColorDialog& dialog = chooseColour(
            &m_window, tr("Backdrop"), m_viewport.backdrop().colour, [this, &checker](const glm::vec3& colour, bool) {
                m_viewport.setBackdrop({Backdrop::Kind::Colour, colour});
                checker.setChecked(false);
            });
        connect(&dialog, &QDialog::rejected, &checker, [&checker, wasChecked] { checker.setChecked(wasChecked); });
    });
}

void ViewActions::showMenu(QPoint global)
{
    auto* menu = new QMenu(&m_window);
    menu->setObjectName(QStringLiteral("viewportMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto add = [&](std::initializer_list<const char*> ids) {
        for (const char* id : ids) {
            menu->addAction(&m_actions.get(id));
        }
        menu->addSeparator();
    };
    add({"view.frameAll", "view.frameAnimation", "view.frameWithoutOutliers", "view.resetCamera"});
    add({"view.front", "view.right", "view.top", "view.back", "view.left", "view.bottom"});
    for (const OverlayAction& entry : kOverlayActions) {
        menu->addAction(&m_actions.get(entry.action));
    }
    add({"view.checker", "view.backdrop"});
    add({"view.copyFrame", "file.export"});
    menu->popup(global);
}

void ViewActions::connectFullScreen()
{
    // Only this one state: a window that was maximised is so again.
    m_actions.on("view.fullScreen", this, [this](bool on) {
        const Qt::WindowStates others = m_window.windowState() & ~Qt::WindowFullScreen;
        m_window.setWindowState(on ? others | Qt::WindowFullScreen : others);
    });
    m_window.installEventFilter(this);
}

/// Keeps the switch true to a window that was opened or left full screen by others.
bool ViewActions::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::WindowStateChange) {
        m_actions.get("view.fullScreen").setChecked(m_window.isFullScreen());
    }
    return QObject::eventFilter(watched, event);
}

QStringList ViewActions::shownOverlays() const
{
    QStringList shown;
    for (const OverlayAction& entry : kOverlayActions) {
        if (entry.remembered && m_viewport.overlays().testFlag(entry.overlay)) {
            shown.append(QLatin1String(entry.action));
        }
    }
    return shown;
}

void ViewActions::showOverlays(const QStringList& ids)
{
    for (const OverlayAction& entry : kOverlayActions) {
        if (entry.remembered) {
            m_actions.get(entry.action).setChecked(ids.contains(QLatin1String(entry.action)));
        }
    }
}

} // namespace fumage::ui
