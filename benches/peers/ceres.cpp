// The calibration that `peers export-calibration` writes, by Ceres with derivatives of its own making (autodiff): processor time in
// nanoseconds, and the cost that it reaches.
#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <ctime>
#include <fstream>
#include <iostream>
#include <vector>

struct Frame {
    double rotation[9], position[3], axis[3];
};

struct Setting {
    Frame frames[7];
    double sigma_m, sigma_rad, prior_m, prior_rad;
};

template <typename T> void multiply(const T *a, const T *b, T *out) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            out[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
}

// As RowMajor rotation: about the moving axes x, y, z.
template <typename T> void rx_ry_rz(const T *r, T *out) {
    using std::cos;
    using std::sin;
    const T sx = sin(r[0]), cx = cos(r[0]), sy = sin(r[1]), cy = cos(r[1]), sz = sin(r[2]), cz = cos(r[2]);
    const T all[9] = {cy * cz, -cy * sz, sy, cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy,
                      sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy};
    std::copy(all, all + 9, out);
}

struct PoseResidual {
    const Setting &setting;
    double turned[6][9]; // each frame's rotation at rest, then its joint's
    double rotation[9], position[3];

    template <typename T> bool operator()(const T *const offsets, T *residual) const {
        T here[9] = {T(1), T(0), T(0), T(0), T(1), T(0), T(0), T(0), T(1)}, at[3] = {T(0), T(0), T(0)};
        for (int i = 0; i < 6; ++i) {
            const T *o = offsets + 6 * i;
            T step[3], turn[9], there[9], next[9], constant[9];
            for (int k = 0; k < 3; ++k)
                step[k] = o[k] + setting.frames[i].position[k];
            for (int k = 0; k < 3; ++k)
                at[k] += here[3 * k] * step[0] + here[3 * k + 1] * step[1] + here[3 * k + 2] * step[2];
            rx_ry_rz(o + 3, turn);
            for (int k = 0; k < 9; ++k)
                constant[k] = T(turned[i][k]);
            multiply(here, turn, there);
            multiply(there, constant, next);
            std::copy(next, next + 9, here);
        }
        const Frame &flange = setting.frames[6];
        T reached[9], constant[9], difference[9], back[9];
        for (int k = 0; k < 3; ++k)
            at[k] += here[3 * k] * flange.position[0] + here[3 * k + 1] * flange.position[1] +
                     here[3 * k + 2] * flange.position[2];
        for (int k = 0; k < 9; ++k)
            constant[k] = T(flange.rotation[k]);
        multiply(here, constant, reached);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                back[3 * i + j] = reached[3 * j + i];
        for (int k = 0; k < 9; ++k)
            constant[k] = T(rotation[k]);
        multiply(constant, back, difference);
        T columns[9], turn[3];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                columns[3 * i + j] = difference[3 * j + i];
        ceres::RotationMatrixToAngleAxis(columns, turn);
        for (int k = 0; k < 3; ++k) {
            residual[k] = (position[k] - at[k]) / setting.sigma_m;
            residual[3 + k] = turn[k] / setting.sigma_rad;
        }
        return true;
    }
};

struct Prior {
    const Setting &setting;
    template <typename T> bool operator()(const T *const offsets, T *residual) const {
        for (int i = 0; i < 36; ++i)
            residual[i] = offsets[i] / (i % 6 < 3 ? setting.prior_m : setting.prior_rad);
        return true;
    }
};

static double processor_s() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

int main(int, char **argv) {
    std::ifstream in(argv[1]);
    Setting setting;
    size_t poses;
    in >> setting.sigma_m >> setting.sigma_rad >> setting.prior_m >> setting.prior_rad >> poses;
    for (Frame &frame : setting.frames) {
        for (double &value : frame.rotation)
            in >> value;
        for (double &value : frame.position)
            in >> value;
        for (double &value : frame.axis)
            in >> value;
    }
    std::vector<PoseResidual> residuals;
    for (size_t n = 0; n < poses; ++n) {
        PoseResidual one{setting};
        for (int i = 0; i < 6; ++i) {
            double q, about[9], rotation[3];
            in >> q;
            for (int k = 0; k < 3; ++k)
                rotation[k] = q * setting.frames[i].axis[k];
            ceres::AngleAxisToRotationMatrix(rotation, ceres::RowMajorAdapter3x3(about));
            multiply(setting.frames[i].rotation, about, one.turned[i]);
        }
        for (double &value : one.rotation)
            in >> value;
        for (double &value : one.position)
            in >> value;
        residuals.push_back(one);
    }
    if (!in)
        return 2;
    double offsets[36], cost = 0.0;
    auto solve = [&] {
        std::fill(offsets, offsets + 36, 0.0);
        ceres::Problem problem;
        for (const PoseResidual &one : residuals)
            problem.AddResidualBlock(new ceres::AutoDiffCostFunction<PoseResidual, 6, 36>(new PoseResidual(one)),
                                     nullptr, offsets);
        problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Prior, 36, 36>(new Prior{setting}), nullptr, offsets);
        ceres::Solver::Options options;
        options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY; // the faster of its dense ones here
        options.num_threads = 1;
        options.logging_type = ceres::SILENT;
        options.function_tolerance = 1e-12;
        options.gradient_tolerance = 0.0;
        options.parameter_tolerance = 1e-12;
        ceres::Solver::Summary summary;
        ceres::Solve(options, &problem, &summary);
        cost = 2.0 * summary.final_cost; // its cost has a factor of a half
    };
    solve();
    const double start = processor_s();
    int rounds = 0;
    do {
        solve();
        ++rounds;
    } while (processor_s() - start < 0.3);
    std::cout.precision(12);
    std::cout << 1e9 * (processor_s() - start) / rounds << " " << cost << "\n";
}
