#pragma once

#include "ui/document/document.h"
#include "ui/document/locks.h"
#include "ui/export/export_entry.h"
#include "ui/face/choice_question.h"
#include "ui/face/file_question.h"
#include "ui/timeline/player.h"

#include <QDialog>

#include <vector>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;
class QSpinBox;

namespace fumage::ui {

class DataChoices;
class ExportProgress;
class FlipbookChoices;
class PictureChoices;
class PreviewPane;
class ParameterRow;

/// What is to be written and where: adds it to the queue of exports. Does not block the window it belongs to. Size and background are parameters of the document.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    /// @param askForFile for the name of the file
    /// @param askForChoice what becomes of files that are there
    ExportDialog(Document& document, Player& player, Locks& locks, ExportQueue& queue, AskForFile askForFile, AskForChoice askForChoice, QWidget* parent);

    [[nodiscard]] ExportPlan plan() const;
    void setKind(ExportKind kind);
    /// Whether an export is on its way into the queue: its files are looked for.
    [[nodiscard]] bool isEntering() const { return m_entry.isBusy(); }

signals:
    /// While it is open, the exported frame should be seen in the picture.
    void shownChanged(bool shown);
    /// To the queue.
    void added(const fumage::ExportPlan& plan);
    /// None is on its way into the queue any more.
    void entryEnded();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    [[nodiscard]] QHBoxLayout* makeRange();
    void buildForm();
    void buildProgress();
    void connectPlan();
    void connectButtons();
    /// As high as its contents, as far as the screen allows.
    void fitScreen();
    void followKind();
    void followFormat();
    /// A person has named the file; its ending may name another format.
    void takePath(const QString& path);
    void followPlan();
    void followProgress();
    void begin();
    /// It is in the queue.
    void followEntered(quint64 id, const ExportPlan& plan, std::optional<OnClash> answered);
    void browse();
    void showInFolder();
    [[nodiscard]] ExportKind kind() const;

    Document& m_document;
    Player& m_player;
    Locks& m_locks;
    ExportQueue& m_queue;
    const AskForFile m_askForFile;
    ExportEntry m_entry;
    QComboBox* m_kind;
    QComboBox* m_format;
    QScrollArea* m_scroll; ///< a small screen may not hold it all
    QLineEdit* m_path;
    QSpinBox* m_first;
    QSpinBox* m_last;
    QSpinBox* m_step;
    DataChoices* m_data;
    FlipbookChoices* m_flipbook;
    PreviewPane* m_preview;
    PictureChoices* m_pictures;
    QLabel* m_files;
    ExportProgress* m_progress;
    QPushButton* m_export;
    QPushButton* m_cancel;
    QPushButton* m_show;
    std::vector<ParameterRow*> m_rows;
    bool m_pathIsSuggested = true;
    int m_imageFormat = 0; ///< that was chosen last, for any kind of picture
};

} // namespace fumage::ui
