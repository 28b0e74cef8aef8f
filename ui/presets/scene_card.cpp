#include "ui/presets/scene_card.h"

#include "ui/document/text.h"

#include <QFontInfo>
#include <QKeyEvent>
#include <QPainter>

namespace fumage::ui {

namespace {

constexpr int kEdge = 200; ///< of the picture, px
constexpr int kMargin = 16;
const QString kName = QStringLiteral("card");

} // namespace

SceneCard::SceneCard(QWidget* parent)
    : QAbstractButton(parent)
    , m_thumbnailer(ThumbnailStore(ThumbnailStore::usualFolder()))
    , m_player(ThumbnailStore(ThumbnailStore::usualFolder()))
{
    setObjectName(QStringLiteral("startCard"));
    setFixedHeight(kEdge);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover); // its edge
    setFocusPolicy(Qt::StrongFocus);
    setEnabled(false);
    connect(&m_thumbnailer, &Thumbnailer::ready, this, [this](const QString&, const QImage& image) {
        m_still = image;
        update();
    });
    connect(&m_player, &LoopPlayer::moved, this, [this] { update(); });
}

QSize SceneCard::sizeHint() const
{
    return {2 * kEdge, kEdge};
}

void SceneCard::setPreset(const Preset& preset, const QString& name, const QString& description)
{
    m_preset = preset;
    m_description = shortened(description, kEdge);
    setText(name);
    setAccessibleName(name);
    setAccessibleDescription(m_description);
    setEnabled(true);
    m_thumbnailer.request(kName, preset.scene, static_cast<int>(kEdge * devicePixelRatioF()));
    m_player.stop();
    follow();
    update();
}

void SceneCard::setPlays(bool plays)
{
    m_plays = plays;
    follow();
}

void SceneCard::follow()
{
    if (m_plays && m_preset && isVisible()) {
        m_player.start(kName, m_preset->scene, static_cast<int>(kEdge * devicePixelRatioF()));
    } else {
        m_player.stop();
    }
}

void SceneCard::showEvent(QShowEvent* event)
{
    QAbstractButton::showEvent(event);
    follow();
}

void SceneCard::hideEvent(QHideEvent* event)
{
    QAbstractButton::hideEvent(event);
    m_player.stop();
}

/// Return is for what has the keyboard, and not for the button that a dialog has for all else.
void SceneCard::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        click();
    } else {
        QAbstractButton::keyPressEvent(event);
    }
}

void SceneCard::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.fillRect(rect(), QColor(30, 34, 40)); // as the dark of thumbnails
    const QImage frame = m_player.frame();
    const QImage& shown = frame.isNull() ? m_still : frame;
    if (!shown.isNull()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(QRect(0, 0, kEdge, kEdge), shown);
    }
    const QRect beside = rect().adjusted(kEdge + kMargin, kMargin, -kMargin, -kMargin);
    QFont large = font();
    constexpr double kLarger = 1.7;
    large.setPixelSize(static_cast<int>(kLarger * QFontInfo(large).pixelSize())); // a style sheet may count in pixels
    painter.setFont(large);
    painter.setPen(Qt::white);
    QRect taken;
    painter.drawText(
        beside, static_cast<int>(Qt::AlignLeft | Qt::AlignTop) | static_cast<int>(Qt::TextSingleLine), text(), &taken);
    painter.setFont(font());
    painter.setPen(QColor(190, 196, 204));
    painter.drawText(beside.adjusted(0, taken.height() + kMargin / 2, 0, 0),
        static_cast<int>(Qt::AlignLeft | Qt::AlignTop) | static_cast<int>(Qt::TextWordWrap), m_description);
    if (hasFocus() || underMouse()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

} // namespace fumage::ui
