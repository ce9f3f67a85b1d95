// Newton with pinocchio's analytic Jacobian on the deformed arms that `peers export` writes: nanoseconds for each solve, by the
// processor's time.
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/multibody.hpp>
#include <pinocchio/spatial.hpp>

#include <Eigen/LU>
#include <ctime>
#include <fstream>
#include <iostream>
#include <vector>

using pinocchio::SE3;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

static SE3 read_pose(std::istream &in) {
    SE3 pose;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            in >> pose.rotation()(i, j);
    for (int i = 0; i < 3; ++i)
        in >> pose.translation()(i);
    return pose;
}

static double processor_s() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

int main(int, char **argv) {
    std::ifstream in(argv[1]);
    size_t minutes, targets;
    in >> minutes >> targets;
    std::vector<pinocchio::Model> models(minutes);
    std::vector<pinocchio::Data> data;
    pinocchio::FrameIndex flange = 0;
    for (auto &model : models) {
        pinocchio::JointIndex at = 0;
        for (int i = 0; i < 6; ++i)
            at = model.addJoint(at, pinocchio::JointModelRZ(), read_pose(in), "j" + std::to_string(i));
        flange = model.addFrame(pinocchio::Frame("flange", at, 0, read_pose(in), pinocchio::OP_FRAME));
        data.emplace_back(model);
    }
    std::vector<SE3> goals;
    for (size_t i = 0; i < targets; ++i)
        goals.push_back(read_pose(in));
    std::vector<Vector6> starts(targets);
    for (auto &start : starts)
        for (int i = 0; i < 6; ++i)
            in >> start(i);
    if (!in)
        return 2;

    size_t solves = 0, failed = 0;
    double sum = 0.0;
    auto all = [&] {
        Eigen::VectorXd q(6);
        pinocchio::Data::Matrix6x jacobian(6, 6);
        for (size_t k = 0; k < targets; ++k)
            for (size_t m = 0; m < minutes; ++m) {
                q = starts[k];
                bool reached = false;
                for (int step = 0; step < 9; ++step) {
                    pinocchio::computeJointJacobians(models[m], data[m], q);
                    const SE3 &there = pinocchio::updateFramePlacement(models[m], data[m], flange);
                    const Vector6 error = pinocchio::log6(there.actInv(goals[k])).toVector();
                    if (error.head<3>().norm() <= 1e-12 && error.tail<3>().norm() <= 1.7453e-11) {
                        reached = true;
                        break;
                    }
                    pinocchio::getFrameJacobian(models[m], data[m], flange, pinocchio::LOCAL, jacobian);
                    q += Matrix6(jacobian).partialPivLu().solve(error);
                }
                failed += !reached;
                sum += q(0);
                ++solves;
            }
    };
    all();
    solves = 0;
    const double start = processor_s();
    while (processor_s() - start < 0.2)
        all();
    const double ns = 1e9 * (processor_s() - start) / solves;
    if (failed != 0 || sum == 0.0)
        return 3;
    std::cout << ns << "\n";
}
