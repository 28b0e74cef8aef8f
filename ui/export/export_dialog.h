#pragma once

#include "ui/document/document.h"
#include "ui/document/locks.h"
#include "ui/document/solo.h"
#include "ui/export/export_submission.h"
#include "ui/widgets/choice_question.h"
#include "ui/widgets/file_question.h"
#include "ui/timeline/player.h"

#include <QComboBox>
#include <QDialog>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

class QFormLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;

namespace fumage::ui {

class DataChoices;
class ExportProgress;
class FlipbookChoices;
class OutputRows;
class PictureChoices;
class PreviewPane;
class RangeRow;
class SummaryRow;

/// What is to be written and where: adds it to the queue of exports. Does not block the window it belongs to. Size and
/// background are parameters of the document.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    /// @param askForFile for the name of the file
    /// @param askForChoice what becomes of files that are there
    ExportDialog(Document& document, Player& player, Locks& locks, ExportQueue& queue, AskForFile askForFile,
        AskForChoice askForChoice, QWidget* parent);

    [[nodiscard]] ExportPlan plan() const;
    void setFrames(const FrameRange& frames);
    /// Names the file, as a person would. @param path empty: it stays what it is
    void setFile(const QString& path);
    void setKind(ExportKind kind) { m_kind->setCurrentIndex(static_cast<int>(kind)); }
    /// What is chosen, for each kind; that of the kind that is shown is the first.
    [[nodiscard]] std::vector<ExportPlan> choices() const;
    /// Shows choices that are remembered, but for frames and files.
    void take(std::span<const ExportPlan> choices);
    /// Says that an export has all layers, while some are looked at alone. @param solo outlives this
    void setSolo(const Solo& solo)
    {
        m_solo = &solo;
        connect(&solo, &Solo::changed, this, &ExportDialog::followPlan);
        followPlan();
    }
    /// Whether an export is on its way into the queue: its files are looked for.
    [[nodiscard]] bool isEntering() const { return m_entry.isBusy(); }

signals:
    /// While it is open, the exported frame should be seen in the picture.
    void shownChanged(bool shown);
    /// To the queue.
    void added(const fumage::ExportPlan& plan);
    /// It is closed, or an export has begun, with choices that are worth remembering.
    void chosen();
    /// None is on its way into the queue any more.
    void entryEnded();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    [[nodiscard]] QHBoxLayout* makePlace();
    void buildForm();
    void buildProgress();
    void connectPlan();
    void connectButtons();
    /// As large as its contents, and as those of the largest kind, as far as the screen allows.
    void fitScreen();
    /// How large the contents of the largest kind are.
    void measureKinds();
    /// Shows what a plan asks about.
    void showRowsOf(const ExportPlan& plan);
    /// What has become of the last export is told no more, unless it is still on its way.
    /// @return whether it is not
    bool forgetDone();
    void followKind();
    void followFormat();
    /// A person has named the file; its ending may name another format.
    void takePath(const QString& path);
    void followPlan();
    /// Where the scene is another, or what is shown here. Playing alone changes nothing of a plan, nor does the layer
    /// that is edited.
    void followEffect(const EffectChange& change)
    {
        const bool isShown = std::any_of(change.parameters.begin(), change.parameters.end(),
            [](const Parameter* parameter) { return parameter->atExport; });
        if (change.isOfScene || isShown || m_markers != m_document.scene().markers) { // which are exported, too
            m_markers = m_document.scene().markers;
            followPlan();
        }
    }
    void followProgress();
    void begin();
    /// It is in the queue.
    void followEntered(quint64 id, const ExportPlan& plan, std::optional<ConflictPolicy> answered);
    void browse();
    [[nodiscard]] ExportKind kind() const { return static_cast<ExportKind>(m_kind->currentIndex()); }
    /// What is chosen for a kind, without its file.
    [[nodiscard]] ExportPlan choiceOf(ExportKind kind) const;
    /// Adds the file that is named, and what is named after it.
    void addPath(ExportPlan& plan) const;

    Document& m_document;
    Player& m_player;
    Locks& m_locks;
    ExportQueue& m_queue;
    const AskForFile m_askForFile;
    ExportSubmission m_entry;
    QComboBox* m_kind;
    QComboBox* m_format;
    QScrollArea* m_scroll; ///< a small screen may not hold it all
    QLineEdit* m_path;
    RangeRow* m_range;
    DataChoices* m_data;
    FlipbookChoices* m_flipbook;
    PreviewPane* m_preview;
    PictureChoices* m_pictures;
    OutputRows* m_output;
    SummaryRow* m_summary;
    const Solo* m_solo = nullptr;
    ExportProgress* m_progress;
    QPushButton* m_export;
    QPushButton* m_cancel;
    QPushButton* m_show;
    QFormLayout* m_form = nullptr;
    std::vector<Marker> m_markers; ///< as the plan was followed last
    QSize m_largest; ///< of the contents of all kinds
    bool m_pathIsSuggested = true;
    std::array<int, kExportKinds> m_formats{}; ///< that were chosen last; those of all images in one place
};

} // namespace fumage::ui
