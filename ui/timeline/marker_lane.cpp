#include "ui/timeline/marker_lane.h"

#include "ui/document/number_text.h"
#include "ui/document/text.h"
#include "ui/timeline/timeline_ruler.h"
#include "ui/widgets/field_keys.h"
#include "ui/widgets/gesture.h"
#include "ui/widgets/plain_text.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fumage::ui {

namespace {

constexpr double kMinFlag = 8.0; ///< width of a flag that has no room for its name
constexpr double kMaxFlag = 160.0;
constexpr double kInset = 4.0; ///< of a name in its flag

} // namespace

MarkerLane::MarkerLane(Document& document, Player& player, const TimelineRuler& ruler, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_player(player)
    , m_ruler(ruler)
    , m_markers(document.scene().markers)
{
    setObjectName(QStringLiteral("markerLane"));
    setAccessibleName(tr("Markers"));
    setFixedHeight(kHeight);
    setVisible(!m_markers.empty());
    connect(&document, &Document::effectChanged, this, &MarkerLane::sync);
    connect(&player, &Player::settingsChanged, this, qOverload<>(&QWidget::update));
}

MarkerLane::~MarkerLane()
{
    if (m_editor != nullptr) {
        m_editor->disconnect(this); // it goes after this
    }
}

void MarkerLane::sync()
{
    if (m_markers == m_document.scene().markers) {
        update(); // at another frame rate they lie elsewhere
        return;
    }
    endRename(false); // it may be another one's by now
    const bool wasShown = !m_markers.empty();
    m_markers = m_document.scene().markers;
    if (wasShown == m_markers.empty()) {
        setVisible(!wasShown);
        emit heightChanged();
    }
    update();
}

double MarkerLane::frameRate() const
{
    return m_document.scene().timeline.frameRate;
}

QRectF MarkerLane::flagOf(std::size_t marker) const
{
    const auto xOf = [this](const Marker& each) { return m_ruler.xOf(each.seconds * frameRate()); };
    const double x = xOf(m_markers[marker]);
    const double name = fontMetrics().horizontalAdvance(toQString(m_markers[marker].name)) + 2.0 * kInset;
    double wide = std::min(name, kMaxFlag);
    const auto next = std::find_if(m_markers.begin() + static_cast<std::ptrdiff_t>(marker), m_markers.end(),
        [&](const Marker& each) { return each.seconds > m_markers[marker].seconds; });
    if (next != m_markers.end()) {
        wide = std::min(wide, xOf(*next) - x - 1.0);
    }
    return {x, 1.0, std::max(kMinFlag, wide), kHeight - 2.0};
}

std::optional<std::size_t> MarkerLane::markerUnder(const QPointF& at) const
{
    constexpr double kReach = 2.0; // pixels before its pole
    for (std::size_t marker = m_markers.size(); marker-- > 0;) {
        if (flagOf(marker).adjusted(-kReach, -kHeight, 0.0, kHeight).contains(at)) {
            return marker;
        }
    }
    return std::nullopt;
}

void MarkerLane::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || m_dragged) {
        return;
    }
    leaveField(*this);
    m_press = event->position();
    m_hasMoved = false;
    m_dragged = markerUnder(m_press);
    m_base = m_markers;
    m_gesture = m_document.beginGesture();
}

void MarkerLane::mouseMoveEvent(QMouseEvent* event)
{
    constexpr double kStill = 3.0;
    m_hasMoved = m_hasMoved || (event->position() - m_press).manhattanLength() > kStill;
    if (m_dragged && m_hasMoved) {
        drag(event->position());
    }
}

void MarkerLane::drag(const QPointF& to)
{
    const double perFrame = m_ruler.xOf(1.0) - m_ruler.xOf(0.0);
    const double frame = std::round(m_base[*m_dragged].seconds * frameRate() + (to.x() - m_press.x()) / perFrame);
    const double seconds = std::clamp(frame, 0.0, m_player.length() - 1.0) / frameRate();
    replaceMarkers(m_document, withMovedMarker(m_base, *m_dragged, seconds), tr("Move a marker"), m_gesture);
}

void MarkerLane::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    const std::optional<std::size_t> dragged = std::exchange(m_dragged, std::nullopt);
    if (dragged && !m_hasMoved) {
        m_player.pause();
        m_player.setFrame(static_cast<int>(std::lround(m_base[*dragged].seconds * frameRate())));
    }
}

void MarkerLane::mouseDoubleClickEvent(QMouseEvent* event)
{
    const std::optional<std::size_t> marker = markerUnder(event->position());
    if (event->button() == Qt::LeftButton && marker) {
        rename(*marker);
    }
}

bool MarkerLane::event(QEvent* event)
{
    if (event->type() == DragCancel::type() && m_dragged) {
        m_dragged.reset();
        replaceMarkers(m_document, m_base, {}, m_gesture);
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ToolTip) {
        const auto& help = *static_cast<QHelpEvent*>(event);
        if (const std::optional<std::size_t> marker = markerUnder(help.pos())) {
            const Marker& over = m_markers[*marker];
            const QString text = tr("%1 at %2 s").arg(onOneLine(toQString(over.name)), formatFixed(over.seconds, 2));
            QToolTip::showText(help.globalPos(), plainToolTip(text), this);
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    return QWidget::event(event);
}

void MarkerLane::rename(std::size_t marker)
{
    endRename(true);
    constexpr int kMinEditor = 120; // pixels
    const QRectF flag = flagOf(marker);
    m_renamed = marker;
    m_editor = new QLineEdit(toQString(m_markers[marker].name), this);
    m_editor->setObjectName(QStringLiteral("markerName"));
    m_editor->setAccessibleName(tr("Name of the marker"));
    m_editor->setFrame(false); // which would leave no room for the letters
    m_editor->setMaxLength(static_cast<int>(kMaxMarkerName));
    const int wide = std::max(kMinEditor, static_cast<int>(flag.width()));
    m_editor->setGeometry(std::clamp(static_cast<int>(flag.x()), 0, std::max(0, width() - wide)), 0, wide, kHeight);
    m_editor->installEventFilter(this);
    connect(m_editor, &QLineEdit::editingFinished, this, [this] { endRename(true); });
    m_editor->selectAll();
    m_editor->show();
    m_editor->setFocus();
}

void MarkerLane::endRename(bool takesOver)
{
    QLineEdit* editor = std::exchange(m_editor, nullptr); // it loses the focus, and says again that it has finished
    if (editor == nullptr) {
        return;
    }
    const QString name = editor->text();
    const bool hasFocus = editor->hasFocus();
    editor->hide();
    editor->deleteLater();
    if (hasFocus) {
        leaveField(*this);
    }
    if (takesOver) {
        renameMarker(m_document, m_renamed, name);
    }
}

bool MarkerLane::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (watched != m_editor || !isKey || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) {
        return QWidget::eventFilter(watched, event);
    }
    event->accept();
    if (event->type() == QEvent::KeyPress) {
        endRename(false);
    }
    return true;
}

void MarkerLane::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("markerMenu"));
    if (const std::optional<std::size_t> marker = markerUnder(event->pos())) {
        menu.addAction(tr("Rename…"), this, [this, marker] { rename(*marker); });
        menu.addAction(tr("Remove"), this, [this, marker] { removeMarker(m_document, *marker); });
        menu.addSeparator();
    }
    menu.addAction(tr("Add a marker at the frame that is shown"), this, [this] { addMarkerHere(m_document); })
        ->setEnabled(m_markers.size() < kMaxMarkers);
    menu.exec(event->globalPos());
}

void MarkerLane::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    QColor cloth = palette().highlight().color();
    cloth.setAlpha(90);
    for (std::size_t marker = 0; marker < m_markers.size(); ++marker) {
        const QRectF flag = flagOf(marker);
        painter.fillRect(flag, cloth);
        painter.setPen(QPen(palette().highlight().color(), 2.0));
        painter.drawLine(QLineF(flag.left(), 0.0, flag.left(), height()));
        const QString name = fontMetrics().elidedText(onOneLine(toQString(m_markers[marker].name)), Qt::ElideRight,
            static_cast<int>(flag.width() - 2.0 * kInset) + 1);
        if (flag.width() > 2.0 * kMinFlag) {
            painter.setPen(palette().text().color());
            painter.drawText(flag.adjusted(kInset, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter, name);
        }
    }
}

} // namespace fumage::ui
