for type in corner edge-corner edge inner-corner inner-edge interior; do
    echo $type $(list-points --type $type <"$DATA/good/grid/square.grid" | cut -d ' ' -f 1)
done
