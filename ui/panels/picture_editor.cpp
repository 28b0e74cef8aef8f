#include "ui/panels/picture_editor.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"
#include "ui/theme/icons.h"
#include "ui/widgets/message_box.h"

#include "core/preset/picture_file.h"

#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QMimeData>
#include <QPainter>
#include <QToolButton>
#include <QUrl>

namespace fumage::ui {

namespace {

constexpr QSize kThumbnail(48, 32);

/// The PNG that is dragged; empty where it is something else.
QString pngOf(const QMimeData& data)
{
    const QList<QUrl> urls = data.urls();
    const QString path = urls.size() == 1 ? urls.constFirst().toLocalFile() : QString();
    return path.endsWith(QStringLiteral(".png"), Qt::CaseInsensitive) ? path : QString();
}

/// As it is on a dark ground, where bright pixels are seen, whatever the theme.
QPixmap thumbnailOf(const Bitmap& picture, double ratio)
{
    const QImage image(picture.pixels().data(), picture.width(), picture.height(), 4 * picture.width(),
        QImage::Format_RGBA8888); // looks at the pixels while it is painted
    QPixmap thumbnail(kThumbnail * ratio);
    thumbnail.setDevicePixelRatio(ratio);
    thumbnail.fill(QColor(24, 24, 24));
    QPainter painter(&thumbnail);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    QRect place({}, image.size().scaled(kThumbnail, Qt::KeepAspectRatio).expandedTo({1, 1}));
    place.moveCenter(QRect({}, kThumbnail).center());
    painter.drawImage(place, image);
    return thumbnail;
}

} // namespace

PictureEditor::PictureEditor(const Parameter& parameter, QWidget* parent, AskForFile askForFile)
    : ParameterEditor(parameter, parent)
    , m_askForFile(std::move(askForFile))
    , m_picture(new QToolButton(this))
    , m_clear(makeIconButton(this, {}, QStringLiteral("delete"), tr("Remove the picture")))
{
    name(*m_picture, QStringLiteral("choose"), {});
    name(*m_clear, QStringLiteral("clear"), tr("remove"));
    m_picture->setToolTip(tr("Press to choose a PNG, or drop one here"));
    m_picture->setIconSize(kThumbnail);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_picture);
    row->addWidget(m_clear);
    row->addStretch();
    setFocusProxy(m_picture);
    setAcceptDrops(true);
    connect(m_picture, &QToolButton::clicked, this, &PictureEditor::choose);
    connect(m_clear, &QToolButton::clicked, this, [this] { change(Bitmap()); });
    showPicture();
}

void PictureEditor::choose()
{
    const QString path = m_askForFile(this,
        {.purpose = FileQuestion::Purpose::Open,
            .title = tr("Choose a picture"),
            .start = {},
            .filter = tr("Pictures (*.png)"),
            .ending = {}});
    if (!path.isEmpty()) {
        take(path);
    }
}

void PictureEditor::take(const QString& path)
{
    const Result<Bitmap> picture = readPictureFile(toPath(path));
    if (picture) {
        change(picture.value());
    } else {
        MessageBox::warn(this, tr("Choose a picture"), translated(picture.error()));
    }
}

void PictureEditor::change(const Bitmap& picture)
{
    m_value = picture;
    showPicture();
    emit edited(m_value, true);
}

void PictureEditor::showPicture()
{
    m_clear->setEnabled(!m_value.empty());
    m_picture->setIcon(m_value.empty() ? QIcon() : QIcon(thumbnailOf(m_value, devicePixelRatioF())));
    m_picture->setText(m_value.empty() ? tr("Choose…") : valueTextOf(parameter(), m_value));
    m_picture->setToolButtonStyle(m_value.empty() ? Qt::ToolButtonTextOnly : Qt::ToolButtonTextBesideIcon);
}

void PictureEditor::setValue(const Value& value)
{
    m_value = std::get<Bitmap>(value);
    showPicture();
}

void PictureEditor::dragEnterEvent(QDragEnterEvent* event)
{
    // Anything else is opened by the window.
    if (pngOf(*event->mimeData()).isEmpty()) {
        event->ignore();
    } else {
        event->acceptProposedAction();
    }
}

/// Reads later: a message must not hold the program that it comes from.
void PictureEditor::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    const QString path = pngOf(*event->mimeData());
    QMetaObject::invokeMethod(
        this, [this, path] { take(path); }, Qt::QueuedConnection);
}

} // namespace fumage::ui
