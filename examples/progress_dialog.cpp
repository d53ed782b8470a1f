// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <QApplication>
#include <QMetaObject>
#include <QProgressDialog>
#include <QTimer>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <future>
#include <iostream>
#include <string>
#include <thread>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
namespace params = CGAL::parameters;

// Lives in the thread of the run, and sends the progress to the dialog in the thread of windows.
class Dialog_visitor : public CGAL::Spectral_segmentation::Segmentation_visitor
{
  QProgressDialog& dialog_;
  const std::atomic<bool>& is_canceled_;

public:
  Dialog_visitor(QProgressDialog& dialog, const std::atomic<bool>& is_canceled)
    : dialog_(dialog), is_canceled_(is_canceled) {}

  void progress(double fraction)
  {
    QMetaObject::invokeMethod(&dialog_, [&dialog = dialog_, fraction] {
      if (!dialog.wasCanceled())
        dialog.setValue(static_cast<int>(100 * fraction));
    }, Qt::QueuedConnection);
  }

  bool go_further() const { return !is_canceled_; }
};

int main(int argc, char* argv[])
{
  QApplication application(argc, argv);
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  auto segment_ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;

  QProgressDialog dialog("Segmenting " + QString::fromStdString(filename), "Cancel", 0, 100);
  std::atomic<bool> is_canceled(false);
  QObject::connect(&dialog, &QProgressDialog::canceled, [&is_canceled] { is_canceled = true; });
  if (argc > 2) // seconds after which Cancel is pressed
    QTimer::singleShot(static_cast<int>(1000 * std::stod(argv[2])), &dialog,
                       &QProgressDialog::canceled);
  application.setQuitOnLastWindowClosed(false);
  dialog.show();

  // The task keeps an exception of the run for the thread that asks for the result.
  std::packaged_task<std::size_t()> run([&mesh, segment_ids, &dialog, &is_canceled] {
    return CGAL::segment_spectral_recursive(
      mesh, segment_ids, params::visitor(Dialog_visitor(dialog, is_canceled)));
  });
  std::thread worker([&run, &application] {
    run();
    QMetaObject::invokeMethod(&application, &QApplication::quit, Qt::QueuedConnection);
  });
  application.exec();
  worker.join();

  std::cout << run.get_future().get() << " segments, " << (is_canceled ? "canceled" : "finished")
            << std::endl;
  return CGAL::IO::write_polygon_mesh("segments.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
